// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <optional>
#include <utility>

#include "core/requirements.h"
#include "geometry/accessible_surface.h"
#include "meniscus/errors.h"
#include "meniscus/pockets.h"
#include "meniscus/threads.h"
#include "pockets/cavity_voxels.h"
#include "pockets/place_regions.h"
#include "pockets/pocket_borders.h"
#include "pockets/pocket_model.h"
#include "pockets/pocket_space.h"
#include "pockets/point_features.h"
#include "pockets/sites.h"

namespace meniscus {
namespace {

constexpr double kTie = 0.1;          // of a score: how much another orientation may change it
constexpr double kMeshSpacing = 1.0;  // Å: of the meshes that divide exact areas
constexpr double kAtSite = 4.0;       // Å: from a site's centre to what it is said to have found

void check(const ExactSurface& exact, std::span<const AtomClass> classes, const PocketOptions& options) {
    require_positive("probe", options.probe);
    require(options.large_probe > options.probe && options.large_probe <= kMostLargeProbe, "large_probe",
            options.large_probe, "larger than the probe and at most 100 Å");
    require(options.spacing >= kLeastPocketSpacing && options.spacing <= kMostPocketSpacing, "spacing", options.spacing,
            "from 0.2 to 2 Å for pockets");
    require(options.count >= 1, "count", options.count, "at least 1");
    for (const PocketPlace& place : options.places) {
        if (place.points.empty()) throw UsageError("places: one has no points");
        require_positive("reach", place.reach);
        for (const Vec3& point : place.points)
            if (!std::isfinite(point.x + point.y + point.z)) throw UsageError("places: a point is not finite");
    }
    if (!classes.empty() && classes.size() != exact.atoms().size())
        throw UsageError("classes: there must be one per atom");
}

// A pocket in the making: a site with its region, or a cavity, which may have a site, or a given place, which may be a
// cavity.
struct Draft {
    std::optional<Site> site;
    std::uint32_t cavity = kNone;  // index among the components
};

// What a cavity has of pocket space: the cavity without what floats in it, and without what the large probe reaches
// there.
double volume_of_cavity(const Measures& small, const Measures& large, std::uint32_t cavity,
                        std::span<const std::uint32_t> cavity_of_large) {
    double volume = small.components[cavity].ses_volume;
    for (const SurfaceComponent& component : small.components)
        if (component.kind == ComponentKind::Outer && component.inside_of == cavity) volume -= component.ses_volume;
    for (std::size_t i = 0; i < large.components.size(); ++i)
        if (cavity_of_large[i] == cavity)
            volume -= (large.components[i].kind == ComponentKind::Cavity ? 1.0 : -1.0) * large.components[i].ses_volume;
    return volume;
}

// The pockets of one structure, step by step.
class PocketFinder {
public:
    PocketFinder(const ExactSurface& small, const PocketOptions& options)
        : small_(small), large_(ExactSurface(small.atoms(), {SurfaceKind::Ses, options.large_probe})) {
        pockets_.options = options;
    }

    Pockets find(std::span<const AtomClass> classes, const Progress& progress) {
        const auto report = [&](const char* stage, double done) {
            if (progress) progress(stage, done);
        };
        report("geometry", 0.0);
        space_ =
            pocket_space(small_.accessible(), large_.accessible(), small_.atoms().centres, pockets_.options.spacing);
        report("exact", 0.0);
        measure_totals();
        report("sites", 0.0);
        find_probabilities(classes);
        label_voxels();
        measure_volumes();
        report("walls", 0.0);
        measure_borders();
        describe();
        sort();
        report("walls", 1.0);
        return std::move(pockets_);
    }

private:
    void measure_totals() {
        const SurfaceTotals& small = small_.measures().totals;
        const SurfaceTotals& large = large_.measures().totals;
        pockets_.volume = large.ses_volume - small.ses_volume;
        pockets_.wall_area = small.ses_area;
        pockets_.mouth_area = large.toroidal_area + large.reentrant_area;
    }

    void find_probabilities(std::span<const AtomClass> classes) {
        probabilities_.assign(space_.size(), 0.0);
        const RankedPoints points = rank_points(space_, small_.accessible(), small_.atoms(), classes);
        std::vector<double> values;
        for (std::size_t i = 0; i < points.voxels.size(); ++i) {
            values.push_back(probability(pocket_model(), points.features[i]));
            probabilities_[points.voxels[i]] = values.back();
            std::copy(points.features[i].begin(), points.features[i].end(), pockets_.features.emplace_back().begin());
        }
        pockets_.points = points.voxels;
        points_ = weighted_points(points.voxels, values);
    }

    void label_voxels() {
        cavities_ = cavity_voxels(space_, small_);
        labels_.assign(space_.size(), kNone);
        if (pockets_.options.places.empty())
            label_sites();
        else
            label_places();
    }

    std::vector<Site> sites() const {
        return find_sites(space_, points_, static_cast<std::size_t>(pockets_.options.count));
    }

    void label_sites() {
        std::vector<std::uint8_t> closed(space_.size());
        for (VoxelId v = 0; v < space_.size(); ++v) closed[v] = static_cast<std::uint8_t>(cavities_[v] != kNone);
        std::vector<Site> open;
        std::vector<Draft> found;
        for (const Site& site : sites()) {
            const std::uint32_t cavity = cavities_[site.densest];
            if (cavity == kNone) {
                found.push_back({site, kNone});
                open.push_back(site);
            } else if (std::none_of(found.begin(), found.end(), [&](const Draft& d) { return d.cavity == cavity; }))
                found.push_back({site, cavity});
        }
        const std::vector<std::uint32_t> region = regions(space_, open, closed);
        const std::vector<double> volumes = rough_volumes(region, open.size());
        std::vector<std::uint32_t> draft_of_site(open.size(), kNone);
        std::uint32_t number = 0;
        for (const Draft& draft : found) {
            const bool is_open = draft.cavity == kNone;
            if (is_open && volumes[number++] < volume_of_probe()) continue;
            if (is_open) draft_of_site[number - 1] = static_cast<std::uint32_t>(drafts_.size());
            drafts_.push_back(draft);
        }
        add_cavities_without_sites();
        for (VoxelId v = 0; v < space_.size(); ++v)
            if (region[v] != kNone) labels_[v] = draft_of_site[region[v]];
        label_cavities();
    }

    void label_places() {
        labels_ = place_regions(space_, pockets_.options.places, cavities_);
        drafts_.resize(pockets_.options.places.size());
        for (VoxelId v = 0; v < space_.size(); ++v) {
            const std::uint32_t cavity = cavities_[v];
            if (labels_[v] == kNone || cavity == kNone) continue;
            if (std::none_of(drafts_.begin(), drafts_.end(), [&](const Draft& d) { return d.cavity == cavity; }))
                drafts_[labels_[v]].cavity = cavity;
        }
        label_cavities();
    }

    // A cavity is one pocket, or none.
    void label_cavities() {
        std::vector<std::uint32_t> of_cavity(small_.measures().components.size(), kNone);
        for (std::uint32_t d = 0; d < drafts_.size(); ++d)
            if (drafts_[d].cavity != kNone) of_cavity[drafts_[d].cavity] = d;
        for (VoxelId v = 0; v < space_.size(); ++v)
            if (cavities_[v] != kNone) labels_[v] = of_cavity[cavities_[v]];
    }

    double cube() const { return space_.grid.spacing() * space_.grid.spacing() * space_.grid.spacing(); }

    // A place that does not hold a probe is not a pocket.
    double volume_of_probe() const {
        return 4.0 / 3.0 * std::numbers::pi * pockets_.options.probe * pockets_.options.probe * pockets_.options.probe;
    }

    std::vector<double> rough_volumes(std::span<const std::uint32_t> region, std::size_t count) const {
        std::vector<double> volumes(count);
        for (VoxelId v = 0; v < space_.size(); ++v)
            if (region[v] != kNone) volumes[region[v]] += space_.shares[v] * cube();
        return volumes;
    }

    // By falling volume, as the components are.
    void add_cavities_without_sites() {
        const std::vector<SurfaceComponent>& components = small_.measures().components;
        for (std::uint32_t i = 0; i < components.size(); ++i) {
            if (components[i].kind != ComponentKind::Cavity) continue;
            if (std::none_of(drafts_.begin(), drafts_.end(), [&](const Draft& d) { return d.cavity == i; }))
                drafts_.push_back({std::nullopt, i});
        }
    }

    // The cavity of the small probe's surface that each component of the large one's lies in, or kNone.
    std::vector<std::uint32_t> cavities_of_large() const {
        std::vector<std::uint32_t> result(large_.measures().components.size(), kNone);
        for (std::size_t i = 0; i < result.size(); ++i) {
            const SurfaceComponent& component = large_.measures().components[i];
            if (component.kind != ComponentKind::Cavity) continue;
            for (VoxelId v = 0; v < space_.size(); ++v) {
                if (cavities_[v] == kNone) continue;
                const double reach = component.inscribed_radius + 2.0 * space_.grid.spacing();
                if (norm(space_.position(v) - component.inscribed_centre) > reach) continue;
                result[i] = cavities_[v];
                break;
            }
        }
        return result;
    }

    void measure_volumes() {
        pockets_.pockets.resize(drafts_.size());
        double cavities = 0.0;
        double in_none = 0.0;  // of the cavities' volume
        const std::vector<std::uint32_t> of_large = cavities_of_large();
        for (std::uint32_t i = 0; i < small_.measures().components.size(); ++i) {
            if (small_.measures().components[i].kind != ComponentKind::Cavity) continue;
            const double volume = volume_of_cavity(small_.measures(), large_.measures(), i, of_large);
            cavities += volume;
            const auto draft =
                std::find_if(drafts_.begin(), drafts_.end(), [&](const Draft& d) { return d.cavity == i; });
            if (draft == drafts_.end()) {
                in_none += volume;
                continue;
            }
            Pocket& pocket = pockets_.pockets[static_cast<std::size_t>(draft - drafts_.begin())];
            pocket.cavity = true;
            pocket.volume = volume;
        }
        std::vector<double> shares(drafts_.size());
        double rest = 0.0;
        double all = 0.0;
        for (VoxelId v = 0; v < space_.size(); ++v) {
            if (cavities_[v] != kNone) continue;
            all += space_.shares[v];
            (labels_[v] == kNone ? rest : shares[labels_[v]]) += space_.shares[v];
        }
        const double open = pockets_.volume - cavities;
        if (all * cube() < 0.5 * open || open < cube()) {  // a grid too coarse for the little that there is
            pockets_.rest_volume = open + in_none;
            return;
        }
        pockets_.scale = open / (all * cube());
        for (std::size_t d = 0; d < drafts_.size(); ++d)
            if (drafts_[d].cavity == kNone) pockets_.pockets[d].volume = pockets_.scale * shares[d] * cube();
        pockets_.rest_volume = pockets_.scale * rest * cube() + in_none;
    }

    void measure_borders() {
        SurfaceOptions options;
        options.method = Method::Direct;
        options.spacing = std::min(kMeshSpacing, pockets_.options.spacing);
        const PocketLabels labels{labels_, drafts_.size()};
        std::vector<std::vector<WallAtom>> wall = walls(space_, labels, mesh(small_, options).mesh, small_.measures());
        std::vector<std::vector<PocketMouth>> mouth =
            mouths(space_, labels, mesh(large_, options).mesh, pockets_.mouth_area);
        std::vector<std::vector<PocketMouth>> opening = openings(space_, labels);
        for (std::size_t d = 0; d < drafts_.size(); ++d) {
            Pocket& pocket = pockets_.pockets[d];
            pocket.wall = std::move(wall[d]);
            pocket.mouths = std::move(mouth[d]);
            if (!pocket.cavity) pocket.openings = std::move(opening[d]);
            for (const WallAtom& atom : pocket.wall) pocket.wall_area += atom.area;
        }
    }

    void describe() {
        for (std::size_t d = 0; d < drafts_.size(); ++d) {
            Pocket& pocket = pockets_.pockets[d];
            if (drafts_[d].site) {
                pocket.score = drafts_[d].site->score;
                pocket.centre = drafts_[d].site->centre;
                pocket.probability = probabilities_[drafts_[d].site->densest];
            } else if (drafts_[d].cavity != kNone)
                pocket.centre = small_.measures().components[drafts_[d].cavity].inscribed_centre;
            else
                pocket.centre = centre_of(pockets_.options.places[d].points);
            pocket.deepest = pocket.centre;
        }
        for (VoxelId v = 0; v < space_.size(); ++v) {
            const auto depth = static_cast<float>(std::max(0.0, -space_.outer[v]));
            pockets_.voxels.push_back({space_.position(v), static_cast<float>(space_.shares[v]), depth,
                                       static_cast<float>(probabilities_[v]), labels_[v]});
            if (labels_[v] == kNone) continue;
            Pocket& pocket = pockets_.pockets[labels_[v]];
            pocket.voxels.push_back(v);
            pocket.probability = std::max(pocket.probability, probabilities_[v]);
            if (-space_.outer[v] <= pocket.depth || !space_.is_within(v)) continue;
            pocket.depth = -space_.outer[v];
            pocket.deepest = space_.position(v);
        }
        if (!pockets_.options.places.empty()) compare_with_sites();
    }

    // How a pocket that was not found, but given, would have been found.
    void compare_with_sites() {
        const std::vector<Site> found = sites();
        for (std::size_t d = 0; d < drafts_.size(); ++d) {
            Pocket& pocket = pockets_.pockets[d];
            pocket.score = largest_density(space_, points_, pocket.voxels);
            const std::vector<Vec3>& points = pockets_.options.places[d].points;
            const std::vector<double> distances = large_.signed_distance(points);
            pocket.points_inside = static_cast<std::size_t>(
                std::count_if(distances.begin(), distances.end(), [](double distance) { return distance < 0.0; }));
            for (std::size_t s = 0; s < found.size() && pocket.site == 0; ++s)
                if (std::any_of(points.begin(), points.end(),
                                [&](const Vec3& point) { return norm(point - found[s].centre) <= kAtSite; }))
                    pocket.site = s + 1;
        }
    }

    static Vec3 centre_of(std::span<const Vec3> points) {
        Vec3 sum;
        for (const Vec3& point : points) sum += point;
        return (1.0 / static_cast<double>(points.size())) * sum;
    }

    // Given ones keep their order.
    void sort() {
        std::vector<Pocket>& list = pockets_.pockets;
        const bool are_given = !pockets_.options.places.empty();
        std::vector<std::uint32_t> order(list.size());
        for (std::uint32_t i = 0; i < order.size(); ++i) order[i] = i;
        const auto by = [&](double Pocket::*value) {
            std::stable_sort(order.begin(), order.end(),
                             [&](std::uint32_t a, std::uint32_t b) { return list[a].*value > list[b].*value; });
        };
        if (pockets_.options.rank == PocketRank::Volume && !are_given) by(&Pocket::volume);
        if (pockets_.options.rank == PocketRank::Depth && !are_given) by(&Pocket::depth);
        std::vector<Pocket> sorted;
        std::vector<std::uint32_t> place(list.size());
        for (const std::uint32_t from : order) {
            place[from] = static_cast<std::uint32_t>(sorted.size());
            sorted.push_back(std::move(list[from]));
            sorted.back().rank = sorted.size();
        }
        list = std::move(sorted);
        for (PocketVoxel& voxel : pockets_.voxels)
            if (voxel.pocket != kNone) voxel.pocket = place[voxel.pocket];
        for (Pocket& pocket : list)
            for (const Pocket& other : list)
                if (&pocket != &other && !are_given && pocket.score > 0.0 &&
                    std::abs(pocket.score - other.score) <= kTie * std::max(pocket.score, other.score))
                    pocket.tied_with.push_back(other.rank);
    }

    ExactSurface small_;
    ExactSurface large_;
    Pockets pockets_;
    PocketSpace space_{BlockGrid(1.0, {}, {}), {}, {}, {}, {}, {}};
    std::vector<double> probabilities_;  // per voxel
    WeightedPoints points_;
    std::vector<std::uint32_t> cavities_;  // per voxel
    std::vector<std::uint32_t> labels_;    // per voxel, indices into drafts_
    std::vector<Draft> drafts_;
};

}  // namespace

std::vector<Check> pocket_checks(const Pockets& pockets) {
    constexpr double kMostOff = 0.02;
    constexpr double kFewCubes = 5.0;  // Å³: what a grid cannot tell of small molecules
    constexpr double kOfLayer = 0.04;  // of a layer on the wall: what it cannot tell of space thinner than its voxels
    constexpr double kRounding = 1e-6;
    double sum = pockets.rest_volume;
    double open = pockets.volume;  // what is scaled
    for (const Pocket& pocket : pockets.pockets) {
        sum += pocket.volume;
        if (pocket.cavity) open -= pocket.volume;
    }
    const double whole = std::max(pockets.volume, 1e-9);
    double scale_bound = std::max(kMostOff, kFewCubes / std::max(open, 1e-9));
    const double layer = pockets.options.spacing * pockets.wall_area;  // a voxel thick
    if (open < layer) scale_bound = std::max(scale_bound, kOfLayer * layer / std::max(open, 1e-9));
    const double off = std::abs(pockets.scale - 1.0);
    const double sum_off = std::abs(sum - pockets.volume) / whole;
    return {{"scale", off <= scale_bound, off, scale_bound},
            {"pocket_volumes", sum_off <= kRounding, sum_off, kRounding}};
}

Pockets find_pockets(const ExactSurface& exact, std::span<const AtomClass> classes, const PocketOptions& options,
                     const RunOptions& run) {
    check(exact, classes, options);
    check_threads(run.threads);
    const ThreadLimit limit(run.threads);
    return PocketFinder(exact.of_same_atoms({SurfaceKind::Ses, options.probe}), options).find(classes, run.progress);
}

}  // namespace meniscus
