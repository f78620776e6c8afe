// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/patch_totals.h"

#include <algorithm>

#include "core/parallel.h"
#include "exact/patch_integrals.h"
#include "exact/reentrant_patches.h"
#include "exact/volume_origins.h"

namespace meniscus {
namespace {

constexpr std::size_t kPatchesPerTask = 128;

// What a patch has of both surfaces; only contact patches have something of the SAS.
struct BothIntegrals {
    PatchIntegrals ses;
    PatchIntegrals sas;

    BothIntegrals& operator+=(const BothIntegrals& other) {
        ses += other.ses;
        sas += other.sas;
        return *this;
    }
};

void accumulate(SurfaceTotals& to, PatchKind kind, const BothIntegrals& patch, double factor = 1.0) {
    to.sas_area += factor * patch.sas.area;
    to.sas_volume += factor * patch.sas.volume;
    to.ses_area += factor * patch.ses.area;
    to.ses_volume += factor * patch.ses.volume;
    add_area(to, kind, factor * patch.ses.area);
}

// Integrals over patches of one kind. Those of the largest component, nearly all, are only summed up.
class PatchSums {
public:
    PatchSums() = default;
    explicit PatchSums(std::uint32_t largest) : largest_(largest) {}

    void add(std::uint32_t component, const BothIntegrals& patch) {
        sum_ += patch;
        if (component != largest_ && component != kNone) elsewhere_.push_back({component, patch});
    }
    PatchSums& operator+=(const PatchSums& other) {
        sum_ += other.sum_;
        elsewhere_.insert(elsewhere_.end(), other.elsewhere_.begin(), other.elsewhere_.end());
        return *this;
    }
    void add_to(PatchTotals& found, PatchKind kind, std::uint32_t largest) const {
        accumulate(found.totals, kind, sum_);
        accumulate(found.components[largest], kind, sum_);
        for (const auto& [component, patch] : elsewhere_) {
            accumulate(found.components[component], kind, patch);
            accumulate(found.components[largest], kind, patch, -1.0);
        }
    }

private:
    struct Elsewhere {
        std::uint32_t component;
        BothIntegrals patch;
    };
    std::uint32_t largest_ = 0;
    BothIntegrals sum_;
    std::vector<Elsewhere> elsewhere_;
};

std::uint32_t largest_component(const SesPatches& patches) {
    std::vector<double> areas(patches.component_count());
    for (const SesPatch& patch : patches.patches()) areas[patch.component] += patch.ses.area;
    return static_cast<std::uint32_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
}

// Finds the components of a first evaluation that the patches of a second are counted to. Without a first evaluation
// there is one component.
class Counterparts {
public:
    explicit Counterparts(const SesPatches* first)
        : first_(first),
          count_(first == nullptr ? 1 : first->component_count()),
          largest_(first == nullptr ? 0 : largest_component(*first)) {}

    std::size_t count() const { return count_; }
    std::uint32_t largest() const { return largest_; }

    std::uint32_t contact(std::uint32_t atom, double area) const {
        return first_ == nullptr ? largest_ : first_->component_like_contact(atom, area);
    }
    std::uint32_t torus(std::uint32_t index, const SasArc& arc, std::uint32_t piece) const {
        return first_ == nullptr ? largest_ : first_->component_like_torus(index, arc, piece);
    }
    std::uint32_t reentrant(std::uint32_t index, const SasVertex& vertex, double area) const {
        return first_ == nullptr ? largest_ : first_->component_like_reentrant(index, vertex, area);
    }

private:
    const SesPatches* first_;
    std::size_t count_;
    std::uint32_t largest_;
};

// An evaluation whose patches are summed up.
struct Evaluated {
    const AccessibleSurface& surface;
    std::uint64_t seed;
    VolumeOrigins origins;
    Counterparts counterparts;
};

PatchSums sum_contact_patches(const Evaluated& of) {
    const AccessibleSurface::Data& data = of.surface.data();
    return parallel_sum<PatchSums>(data.atoms.size(), kPatchesPerTask, [&](std::size_t begin, std::size_t end) {
        PatchSums sums(of.counterparts.largest());
        SphericalRegions regions;
        for (std::size_t i = begin; i < end; ++i) {
            if (data.exposed[i] == 0) continue;
            const auto atom = static_cast<std::uint32_t>(i);
            regions.measure(data.caps_of(atom), data.contour_of(atom));
            const Vec3 centre = data.atoms.centres[i] - of.origins.of(atom);
            for (const SphericalRegion& region : regions.regions()) {
                const PatchIntegrals ses = sphere_patch(centre, data.rho[i] - data.probe, region, 1);
                sums.add(of.counterparts.contact(atom, ses.area), {ses, sphere_patch(centre, data.rho[i], region, 1)});
            }
        }
        return sums;
    });
}

PatchSums sum_toroidal_patches(const Evaluated& of) {
    const AccessibleSurface::Data& data = of.surface.data();
    return parallel_sum<PatchSums>(data.arcs.size(), kPatchesPerTask, [&](std::size_t begin, std::size_t end) {
        PatchSums sums(of.counterparts.largest());
        for (std::size_t a = begin; a < end; ++a) {
            const SasArc& arc = data.arcs[a];
            const ToroidalPatch torus = toroidal_patch(arc, data.probe);
            for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(torus.count); ++k)
                sums.add(
                    of.counterparts.torus(static_cast<std::uint32_t>(a), arc, k),
                    {toroidal_piece(arc, data.probe, torus.pieces[k], arc.centre - of.origins.of(arc.atoms[0])), {}});
        }
        return sums;
    });
}

// Also tells in `found` how the trimming went.
PatchSums sum_reentrant_patches(const Evaluated& of, PatchTotals& found) {
    const AccessibleSurface::Data& data = of.surface.data();
    struct Trimmed {
        PatchSums sums;
        std::vector<std::uint32_t> unresolved;
        bool degenerate = false;
    };
    const std::size_t tasks = (data.vertices.size() + kVerticesPerTask - 1) / kVerticesPerTask;
    std::vector<Trimmed> trimmed(tasks, {PatchSums(of.counterparts.largest()), {}});
    for_each_reentrant_patch(of.surface, of.seed, [&](std::uint32_t v, const ReentrantPatch& patch) {
        Trimmed& task = trimmed[v / kVerticesPerTask];
        task.degenerate = task.degenerate || patch.degenerate;
        if (!patch.consistent) task.unresolved.push_back(v);
        const SasVertex& vertex = data.vertices[v];
        const Vec3 centre = vertex.position - of.origins.of(vertex.atoms[0]);
        for (const SphericalRegion& region : patch.regions) {
            const PatchIntegrals ses = sphere_patch(centre, data.probe, region, -1);
            task.sums.add(of.counterparts.reentrant(v, vertex, ses.area), {ses, {}});
        }
    });
    PatchSums sums(of.counterparts.largest());
    for (const Trimmed& task : trimmed) {
        sums += task.sums;
        found.degenerate = found.degenerate || task.degenerate;
        found.unresolved.insert(found.unresolved.end(), task.unresolved.begin(), task.unresolved.end());
    }
    return sums;
}

}  // namespace

PatchTotals sum_patches(const AccessibleSurface& surface, std::uint64_t seed, const SesPatches* first) {
    const Evaluated of{surface, seed, VolumeOrigins(surface.data()), Counterparts(first)};
    const std::uint32_t largest = of.counterparts.largest();
    PatchTotals found;
    found.degenerate = has_coincident_probes(surface.data());
    found.components.resize(of.counterparts.count());
    sum_contact_patches(of).add_to(found, PatchKind::Contact, largest);
    sum_toroidal_patches(of).add_to(found, PatchKind::Toroidal, largest);
    sum_reentrant_patches(of, found).add_to(found, PatchKind::Reentrant, largest);
    return found;
}

}  // namespace meniscus
