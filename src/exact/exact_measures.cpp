// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "core/number_text.h"
#include "core/parallel.h"
#include "exact/component_places.h"
#include "exact/measure_surface.h"
#include "exact/patch_totals.h"
#include "exact/ses_patches.h"
#include "geometry/accessible_surface.h"
#include "meniscus/measures.h"
#include "meniscus/threads.h"

namespace meniscus {
namespace {

// What two evaluations may differ by, relative, before a third is asked.
constexpr double kAgreement = 1e-7;
constexpr double kAgreementIfDegenerate = 1e-5;
// Where two probe positions all but coincide, a perturbation of 1e-10 Å moves 1e-7 of the area from one kind of
// patch to another without changing the sum: the split is held to this alone, and its error estimate shows it.
constexpr double kAgreementOfSplit = 1e-5;
// What double precision may leave open, relative.
constexpr double kResolved = 1e-6;
constexpr std::uint64_t kMostSeeds = 5;
constexpr std::size_t kMostDisputed = 10;

// What measures leave open that two evaluations may have in common: that all radii are wrong by the perturbation, and
// all places by rounding (dV = A dr, dA = 2 H A dr); and that patches on spheres of radius rho are differences of terms
// as large as rho² and rho³.
class PrecisionLimit {
public:
    PrecisionLimit(const AccessibleSurface::Data& data, double perturbation) : rho_(data.rho_max) {
        for (const Vec3& c : data.atoms.centres)
            farthest_ = std::max({farthest_, std::abs(c.x), std::abs(c.y), std::abs(c.z)});
        smallest_ = *std::min_element(data.atoms.radii.begin(), data.atoms.radii.end());
        amplitude_ = perturbation + kEpsilon * farthest_;
        curvature_ = std::max(1.0, 1.0 / (data.probe > 0.0 ? std::min(smallest_, data.probe) : smallest_));
    }

    double of_area(double area, std::size_t patches) const {
        return 2.0 * amplitude_ * curvature_ * area + rounding(patches);
    }
    /// Of what an area encloses.
    double of_volume(double area, std::size_t patches) const {
        return 2.0 * amplitude_ * area + rho_ * rounding(patches);
    }

    std::string text() const {
        return joined("double precision is not sufficient for spheres of ", in_short(smallest_, 3), " to ",
                      in_short(rho_, 3), " Å at ", in_short(farthest_, 3), " Å from the origin");
    }

private:
    static constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

    double rounding(std::size_t patches) const {
        return kEpsilon * std::sqrt(static_cast<double>(patches)) * rho_ * rho_;
    }

    double rho_;  // Å, of the largest enlarged sphere
    double farthest_ = 0.0;
    double smallest_ = 0.0;
    double amplitude_ = 0.0;
    double curvature_ = 1.0;
};

constexpr double SurfaceTotals::*kAllTotals[] = {&SurfaceTotals::sas_area,      &SurfaceTotals::sas_volume,
                                                 &SurfaceTotals::ses_area,      &SurfaceTotals::ses_volume,
                                                 &SurfaceTotals::contact_area,  &SurfaceTotals::toroidal_area,
                                                 &SurfaceTotals::reentrant_area};

// An evaluation: the exposed features and the patches they leave.
struct Evaluation {
    const AccessibleSurface& surface;
    SesPatches patches;
    PatchTotals sums;

    Evaluation(const AccessibleSurface& of, std::uint64_t seed) : surface(of), patches(of, seed) {
        SurfaceTotals& totals = sums.totals;
        for (const SesPatch& patch : patches.patches()) {
            totals.sas_area += patch.sas.area;
            totals.sas_volume += patch.sas.volume;
            totals.ses_volume += patch.ses.volume;
            add_area(totals, patch.kind, patch.ses.area);
        }
        totals.ses_area = totals.contact_area + totals.toroidal_area + totals.reentrant_area;
        sums.degenerate = patches.degenerate();
        sums.unresolved = patches.unresolved();
    }
};

// One with the surface that it is of.
struct OwnEvaluation {
    AccessibleSurface surface;
    Evaluation evaluation;

    OwnEvaluation(AccessibleSurface of, std::uint64_t seed) : surface(std::move(of)), evaluation(surface, seed) {}
};

// Another evaluation of the same surface, of which only the sums are wanted.
struct SecondEvaluation {
    std::uint64_t seed;
    double perturbation = 0.0;
    PatchTotals sums;

    SecondEvaluation(const Evaluation& first, std::uint64_t with_seed) : seed(with_seed) {
        const AccessibleSurface perturbed = first.surface.perturbed(seed);
        perturbation = perturbed.data().perturbation;
        sums = sum_patches(perturbed, seed, &first.patches);
    }
};

PrecisionLimit precision_of(const Evaluation& first, const SecondEvaluation& second) {
    const AccessibleSurface::Data& data = first.surface.data();
    return {data, std::max(data.perturbation, second.perturbation)};
}

bool is_resolved(const SurfaceTotals& totals, const PrecisionLimit& precision, std::size_t patches) {
    return precision.of_area(totals.ses_area, patches) <= kResolved * totals.ses_area &&
           precision.of_volume(totals.ses_area, patches) <= kResolved * std::abs(totals.ses_volume);
}

bool agree(const PatchTotals& a, const PatchTotals& b) {
    const bool degenerate = a.degenerate || b.degenerate;
    const double tolerance = degenerate ? kAgreementIfDegenerate : kAgreement;
    const auto close = [&](double SurfaceTotals::*total, double within) {
        return std::abs(a.totals.*total - b.totals.*total) <= within;
    };
    const double split = kAgreementOfSplit * a.totals.ses_area;
    return a.unresolved.empty() && b.unresolved.empty() &&
           close(&SurfaceTotals::sas_area, tolerance * a.totals.sas_area) &&
           close(&SurfaceTotals::ses_area, tolerance * a.totals.ses_area) &&
           close(&SurfaceTotals::sas_volume, tolerance * std::abs(a.totals.sas_volume)) &&
           close(&SurfaceTotals::ses_volume, tolerance * std::abs(a.totals.ses_volume)) &&
           close(&SurfaceTotals::contact_area, split) && close(&SurfaceTotals::toroidal_area, split) &&
           close(&SurfaceTotals::reentrant_area, split);
}

// Difference of two evaluations that share no perturbation, plus what they may have in common.
SurfaceTotals estimate_errors(const SurfaceTotals& a, const SurfaceTotals& b, const PrecisionLimit& precision,
                              std::size_t patches) {
    SurfaceTotals errors;
    for (const auto total : kAllTotals) {
        const bool is_volume = total == &SurfaceTotals::sas_volume || total == &SurfaceTotals::ses_volume;
        errors.*total = 3.0 * std::abs(a.*total - b.*total) + 1e-14 * std::abs(a.*total) +
                        (is_volume ? precision.of_volume(std::max(a.sas_area, a.ses_area), patches)
                                   : precision.of_area(a.*total, patches));
    }
    return errors;
}

using PatchAtoms = std::array<std::uint32_t, 3>;

// In the caller's order.
PatchAtoms atoms_of(const SesPatches& patches, const SesPatch& patch) {
    PatchAtoms atoms = patches.atoms_of(patch);
    for (std::uint32_t& atom : atoms)
        if (atom != kNone) atom = patches.data().atoms.original[atom];
    return atoms;
}

// What the first of a patch's atoms has of its area.
double area_of_first(const SesPatch& patch) {
    if (patch.kind == PatchKind::Toroidal) return patch.area_at_first;
    return patch.kind == PatchKind::Contact ? patch.ses.area : patch.ses.area / 3.0;
}

// With the components' numbers of the evaluation.
std::vector<PatchMeasure> list_patches(const SesPatches& patches) {
    std::vector<PatchMeasure> list;
    list.reserve(patches.patches().size());
    for (const SesPatch& patch : patches.patches())
        list.push_back({patch.kind, atoms_of(patches, patch), patch.component, patch.ses.area, patch.sas.area,
                        area_of_first(patch)});
    return list;
}

void share_among_atoms(Measures& measures) {
    for (const PatchMeasure& patch : measures.patches) {
        if (patch.kind == PatchKind::Contact) {
            measures.atoms[patch.atoms[0]].contact_area += patch.ses_area;
            measures.atoms[patch.atoms[0]].sas_area += patch.sas_area;
        } else if (patch.kind == PatchKind::Toroidal) {
            measures.atoms[patch.atoms[0]].toroidal_area += patch.first_share;
            measures.atoms[patch.atoms[1]].toroidal_area += patch.ses_area - patch.first_share;
        } else {
            for (const std::uint32_t atom : patch.atoms) measures.atoms[atom].reentrant_area += patch.first_share;
        }
    }
}

PatchAreas areas_of_largest_sas_piece(const SesPatches& patches) {
    std::vector<double> sas_area(patches.sas_component_count());
    for (const SesPatch& patch : patches.patches())
        if (patch.kind == PatchKind::Contact) sas_area[patch.sas_component] += patch.sas.area;
    const auto largest = std::max_element(sas_area.begin(), sas_area.end()) - sas_area.begin();
    PatchAreas areas;
    for (const SesPatch& patch : patches.patches()) {
        if (patch.sas_component != static_cast<std::uint32_t>(largest)) continue;
        if (patch.kind == PatchKind::Contact) areas.contact += patch.ses.area;
        if (patch.kind == PatchKind::Toroidal) areas.toroidal += patch.ses.area;
        if (patch.kind == PatchKind::Reentrant) areas.reentrant += patch.ses.area;
    }
    return areas;
}

// Sums per component, in the numbering of the evaluation.
struct ComponentSums {
    SurfaceComponent component;
    double signed_volume = 0.0;
    Vec3 first_moment;  // about `origin`
    Vec3 origin;
    std::size_t patches = 0;
    std::vector<std::uint32_t> sas_pieces;
    std::vector<std::uint32_t> atoms;
    // Of cavities:
    Box room;                  // round its atoms
    std::vector<Vec3> probes;  // vertices, or the middle of arcs
};

std::vector<ComponentSums> sum_components(const SesPatches& patches) {
    const AccessibleSurface::Data& data = patches.data();
    std::vector<ComponentSums> sums(patches.component_count());
    std::vector<std::uint32_t> listed_in(data.atoms.size(), kNone);  // of each atom: the component that has it last
    for (const SesPatch& patch : patches.patches()) {
        ComponentSums& sum = sums[patch.component];
        ++sum.patches;
        sum.component.ses_area += patch.ses.area;
        sum.signed_volume += patch.ses.volume;
        sum.first_moment += patch.ses.first_moment;
        sum.origin = patches.origin_of(patch);
        sum.component.sas_area += patch.sas.area;
        sum.component.sas_volume += patch.sas.volume;
        for (const std::uint32_t atom : patches.atoms_of(patch)) {
            if (atom == kNone || listed_in[atom] == patch.component) continue;
            listed_in[atom] = patch.component;
            sum.atoms.push_back(data.atoms.original[atom]);
        }
        add_area(sum.component, patch.kind, patch.ses.area);
        if (patch.kind == PatchKind::Contact &&
            (sum.sas_pieces.empty() || sum.sas_pieces.back() != patch.sas_component))
            sum.sas_pieces.push_back(patch.sas_component);
    }
    return sums;
}

// What largest_inscribed_sphere asks for: boxes round the atoms of cavities, and probe positions inside.
void find_rooms_of_cavities(const SesPatches& patches, std::vector<ComponentSums>& sums) {
    const AccessibleSurface::Data& data = patches.data();
    for (const SesPatch& patch : patches.patches()) {
        ComponentSums& sum = sums[patch.component];
        if (sum.signed_volume > 0.0) continue;
        for (const std::uint32_t atom : patches.atoms_of(patch)) {
            if (atom == kNone) continue;
            const Vec3& centre = data.atoms.centres[atom];
            sum.room.include(Box{centre, centre}.grown(data.atoms.radii[atom]));
        }
        if (patch.kind == PatchKind::Toroidal) {
            const SasArc& arc = data.arcs[patch.feature];
            sum.probes.push_back(arc.centre + arc.radius * arc.middle);
        } else if (patch.kind == PatchKind::Reentrant) {
            sum.probes.push_back(data.vertices[patch.feature].position);
        }
    }
}

std::vector<std::uint32_t> sorted_without_repeats(std::vector<std::uint32_t> numbers) {
    std::sort(numbers.begin(), numbers.end());
    numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
    numbers.shrink_to_fit();
    return numbers;
}

void finish_component(const Evaluation& evaluation, ComponentSums& sum) {
    SurfaceComponent& component = sum.component;
    component.kind = sum.signed_volume > 0.0 ? ComponentKind::Outer : ComponentKind::Cavity;
    component.ses_volume = std::abs(sum.signed_volume);
    component.sas_volume = std::abs(component.sas_volume);
    component.sas_components = sorted_without_repeats(std::move(sum.sas_pieces)).size();
    component.centre = sum.origin + (1.0 / component.ses_area) * sum.first_moment;
    component.atoms = sorted_without_repeats(std::move(sum.atoms));
    if (sum.probes.empty()) return;
    const InscribedSphere sphere = largest_inscribed_sphere(evaluation.surface, sum.probes, sum.room);
    component.inscribed_centre = sphere.centre;
    component.inscribed_radius = sphere.radius;
}

// Areas and signed volumes of a component.
SurfaceTotals totals_of(const ComponentSums& sum) {
    const SurfaceComponent& c = sum.component;
    return {.sas_area = c.sas_area,
            .sas_volume = c.sas_volume,
            .ses_area = c.ses_area,
            .ses_volume = sum.signed_volume,
            .contact_area = c.contact_area,
            .toroidal_area = c.toroidal_area,
            .reentrant_area = c.reentrant_area};
}

// Components by falling volume, with errors if there is a check; number[c] is the place of the evaluation's component
// c.
std::vector<SurfaceComponent> make_components(const Evaluation& evaluation, const SecondEvaluation* check,
                                              const MeasureOptions& options, std::vector<std::uint32_t>& number) {
    std::vector<ComponentSums> sums = sum_components(evaluation.patches);
    if (options.cavities) find_rooms_of_cavities(evaluation.patches, sums);
    if (check != nullptr) {
        const PrecisionLimit precision = precision_of(evaluation, *check);
        for (std::size_t c = 0; c < sums.size(); ++c)
            sums[c].component.errors =
                estimate_errors(totals_of(sums[c]), check->sums.components[c], precision, sums[c].patches);
    }
    parallel_for(sums.size(), 1, [&](std::size_t c) { finish_component(evaluation, sums[c]); });
    std::vector<double> volumes(sums.size());
    std::transform(sums.begin(), sums.end(), volumes.begin(),
                   [](const ComponentSums& sum) { return sum.signed_volume; });
    std::vector<std::uint32_t> inside_of(sums.size(), kNone);
    if (options.cavities) inside_of = nest_components(evaluation.surface, evaluation.patches, volumes);

    std::vector<std::uint32_t> order(sums.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return sums[a].component.ses_volume > sums[b].component.ses_volume;
    });
    number.resize(sums.size());
    for (std::uint32_t place = 0; place < order.size(); ++place) number[order[place]] = place;
    std::vector<SurfaceComponent> components;
    components.reserve(order.size());
    for (const std::uint32_t c : order) {
        components.push_back(std::move(sums[c].component));
        if (inside_of[c] != kNone) components.back().inside_of = number[inside_of[c]];
    }
    return components;
}

std::string name_patch(const AccessibleSurface::Data& data, std::uint32_t vertex) {
    const auto& [i, j, k] = data.vertices[vertex].atoms;
    const auto& number = data.atoms.original;
    return joined("reentrant patch of atoms ", number[i], " ", number[j], " ", number[k]);
}

// Names what two evaluations do not agree on: unresolved patches, then the atoms whose shares differ most.
std::vector<std::string> name_disputed(const Evaluation& a, const Evaluation& b, std::size_t atom_count) {
    std::vector<std::string> names;
    for (const Evaluation* evaluation : {&a, &b})
        for (const std::uint32_t v : evaluation->patches.unresolved())
            names.push_back(name_patch(evaluation->surface.data(), v));
    const auto shares_of = [&](const Evaluation& evaluation) {
        Measures measures;
        measures.atoms.resize(atom_count);
        measures.patches = list_patches(evaluation.patches);
        share_among_atoms(measures);
        return measures.atoms;
    };
    const std::vector<AtomMeasure> of_a = shares_of(a);
    const std::vector<AtomMeasure> of_b = shares_of(b);
    std::multimap<double, std::size_t, std::greater<>> by_difference;
    for (std::size_t i = 0; i < atom_count; ++i)
        by_difference.emplace(std::abs(of_a[i].ses_area() - of_b[i].ses_area()), i);
    for (const auto& [difference, atom] : by_difference)
        if (names.empty() || (difference > 1e-6 && names.size() < kMostDisputed))
            names.push_back(joined("patches of atom ", atom, " by ", in_short(difference, 3), " Å²"));
    return names;
}

void add_depths(const AccessibleSurface& surface, const Atoms& atoms, Measures& measures) {
    const std::vector<double> distances = signed_distance(surface, atoms.centres);
    for (std::size_t i = 0; i < atoms.size(); ++i) measures.atoms[i].depth = -distances[i];
}

Measures describe(const Atoms& atoms, const MeasureOptions& options, const Evaluation& evaluation,
                  const SecondEvaluation* check) {
    Measures measures;
    measures.options = options;
    measures.totals = evaluation.sums.totals;
    measures.sas_components = evaluation.patches.sas_component_count();
    measures.largest_sas_piece = areas_of_largest_sas_piece(evaluation.patches);
    measures.atoms.resize(atoms.size());
    measures.patches = list_patches(evaluation.patches);
    share_among_atoms(measures);
    std::vector<std::uint32_t> number;
    measures.components = make_components(evaluation, check, options, number);
    for (PatchMeasure& patch : measures.patches) patch.component = number[patch.component];
    if (options.depth) add_depths(evaluation.surface, atoms, measures);
    if (!options.patches) std::vector<PatchMeasure>().swap(measures.patches);
    return measures;
}

}  // namespace

Measures measure(const Atoms& atoms, const MeasureOptions& options) {
    const ThreadLimit limit(options.threads);
    return measure(AccessibleSurface(atoms, options.probe), atoms, options);
}

Measures measure(const AccessibleSurface& surface, const Atoms& atoms, const MeasureOptions& options) {
    const ThreadLimit limit(options.threads);
    auto given = std::make_unique<const Evaluation>(surface, 0);
    std::unique_ptr<const OwnEvaluation> own;  // in place of the given one, where others do not agree with it
    SecondEvaluation check(*given, 1);
    while (!agree(own ? own->evaluation.sums : given->sums, check.sums) && check.seed + 1 < kMostSeeds) {
        own = std::make_unique<const OwnEvaluation>(surface.perturbed(check.seed), check.seed);
        given.reset();
        check = SecondEvaluation(own->evaluation, check.seed + 1);
    }
    const Evaluation& evaluation = own ? own->evaluation : *given;
    MeasureOptions with_probe = options;
    with_probe.probe = surface.probe();
    Measures measures = describe(atoms, with_probe, evaluation, &check);
    const SurfaceTotals& totals = evaluation.sums.totals;
    const PrecisionLimit precision = precision_of(evaluation, check);
    const std::size_t patches = evaluation.patches.patches().size();
    measures.errors = estimate_errors(totals, check.sums.totals, precision, patches);
    measures.degenerate = evaluation.sums.degenerate || check.sums.degenerate;
    const bool agreed = agree(evaluation.sums, check.sums);
    const bool resolved = is_resolved(totals, precision, patches);
    measures.agreed = agreed && resolved;
    if (!resolved)
        measures.disputed = {precision.text()};
    else if (!agreed) {
        const OwnEvaluation other(surface.perturbed(check.seed), check.seed);
        measures.disputed = name_disputed(evaluation, other.evaluation, atoms.size());
    }
    return measures;
}

Measures measure_once(const AccessibleSurface& surface, const Atoms& atoms) {
    const Evaluation evaluation(surface, 0);
    Measures measures = describe(atoms, {.probe = surface.probe()}, evaluation, nullptr);
    measures.degenerate = evaluation.sums.degenerate;
    measures.agreed = evaluation.sums.unresolved.empty();
    return measures;
}

}  // namespace meniscus
