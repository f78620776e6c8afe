// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/point_features.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.h"
#include "geometry/accessible_surface.h"
#include "geometry/accessible_surface_data.h"
#include "pockets/lattice_average.h"
#include "space/box_tree.h"
#include "space/cell_list.h"

namespace meniscus {
namespace {

constexpr double kFarthest = 10.0;   // Å: of the atoms that count
constexpr double kClear = 1.0;       // Å between a point and the nearest atom
constexpr double kMostDepth = 12.0;  // Å that count in averages
constexpr double kLimit = 5.0;       // Å of LimitedDepth10
constexpr std::array kProbes{2.0, 3.3, 4.6, 5.5};
constexpr std::size_t kNarrow = 2;  // of these, whose space is averaged

// An atom as the sums over neighbours need it.
struct Neighbour {
    Vec3 centre;
    double radius = 0.0;
    std::uint8_t kind = kAtomClasses;
};

// The atoms near the points of one block after the other.
class Neighbourhood {
public:
    Neighbourhood(const CanonicalAtoms& atoms, std::span<const AtomClass> classes) : cells_(atoms) {
        for (std::size_t i = 0; i < atoms.size(); ++i) {
            const AtomClass kind = classes.empty() ? AtomClass::Other : classes[atoms.original[i]];
            all_.push_back({atoms.centres[i], atoms.radii[i], static_cast<std::uint8_t>(kind)});
            thickest_ = std::max(thickest_, atoms.radii[i]);
        }
    }

    std::vector<Neighbour> near(const Box& box, double reach) const {
        std::vector<Neighbour> result;
        cells_.for_each_cell_near(box, reach, [&](std::uint32_t begin, std::uint32_t end) {
            result.insert(result.end(), all_.begin() + begin, all_.begin() + end);
        });
        return result;
    }
    double thickest() const { return thickest_; }

private:
    CellList cells_;
    std::vector<Neighbour> all_;
    double thickest_ = 0.0;
};

// Voxels block by block, as ranges of a list of voxels.
std::vector<std::size_t> block_ranges(const PocketSpace& space, std::span<const VoxelId> voxels) {
    std::vector<std::size_t> begins;
    for (std::size_t i = 0; i < voxels.size(); ++i)
        if (i == 0 || space.nodes[voxels[i]] / kBlockNodes != space.nodes[voxels[i - 1]] / kBlockNodes)
            begins.push_back(i);
    begins.push_back(voxels.size());
    return begins;
}

template <class Visit>
void for_each_block(const PocketSpace& space, std::span<const VoxelId> voxels, const Neighbourhood& atoms, double reach,
                    const Visit& visit) {
    const std::vector<std::size_t> begins = block_ranges(space, voxels);
    parallel_for(begins.size() - 1, 1, [&](std::size_t b) {
        Box box;
        for (std::size_t i = begins[b]; i < begins[b + 1]; ++i) box.include(space.position(voxels[i]));
        const std::vector<Neighbour> near = atoms.near(box, reach);
        for (std::size_t i = begins[b]; i < begins[b + 1]; ++i) visit(i, near);
    });
}

bool is_clear(const Vec3& point, std::span<const Neighbour> near) {
    return std::none_of(near.begin(), near.end(),
                        [&](const Neighbour& atom) { return norm(point - atom.centre) - atom.radius < kClear; });
}

std::vector<VoxelId> clear_voxels(const PocketSpace& space, const Neighbourhood& atoms) {
    std::vector<VoxelId> within;
    for (VoxelId v = 0; v < space.size(); ++v)
        if (space.is_within(v)) within.push_back(v);
    std::vector<std::uint8_t> clear(within.size());
    for_each_block(space, within, atoms, kClear + atoms.thickest(),
                   [&](std::size_t i, std::span<const Neighbour> near) {
                       clear[i] = static_cast<std::uint8_t>(is_clear(space.position(within[i]), near));
                   });
    std::vector<VoxelId> result;
    for (std::size_t i = 0; i < within.size(); ++i)
        if (clear[i] != 0) result.push_back(within[i]);
    return result;
}

// Sums over the atoms closer than a reach, each with the weight 1 - d / reach.
struct WeightedSums {
    double all = 0.0;
    Vec3 directions;
    std::array<double, kAtomClasses + 1> by_class{};

    void add(const Neighbour& atom, const Vec3& away, double distance, double reach) {
        const double weight = 1.0 - distance / reach;
        all += weight;
        if (distance > 0.0) directions += (weight / distance) * away;
        by_class[atom.kind] += weight;
    }
    double asymmetry() const { return norm(directions) / (all + 1e-9); }
    double share(std::size_t kind) const { return by_class[kind] / (all + 0.1); }
};

void add_neighbours(const Vec3& point, std::span<const Neighbour> near, PointFeatures& features) {
    constexpr double kClose = 6.0;
    constexpr double kMiddle = 8.0;
    WeightedSums close;
    WeightedSums far;
    std::array<double, 3> counts{};
    for (const Neighbour& atom : near) {
        const Vec3 away = atom.centre - point;
        const double squared = squared_norm(away);
        if (squared >= kFarthest * kFarthest) continue;
        const double distance = std::sqrt(squared);
        far.add(atom, away, distance, kFarthest);
        counts[2] += 1.0;
        if (distance < kMiddle) counts[1] += 1.0;
        if (distance >= kClose) continue;
        close.add(atom, away, distance, kClose);
        counts[0] += 1.0;
    }
    features[Near6] = counts[0];
    features[Near8] = counts[1];
    features[Near10] = counts[2];
    features[Asymmetry6] = close.asymmetry();
    features[Asymmetry10] = far.asymmetry();
    for (std::size_t kind = 0; kind < kAtomClasses; ++kind) {
        features[Classes6 + kind] = close.share(kind);
        features[Classes10 + kind] = far.share(kind);
    }
}

void add_depths(const PocketSpace& space, const Atoms& atoms, RankedPoints& points) {
    std::vector<Vec3> positions;
    for (const VoxelId v : points.voxels) positions.push_back(space.position(v));
    for (std::size_t level = 0; level < kProbes.size(); ++level) {
        const std::vector<double> distances = signed_distance(AccessibleSurface(atoms, kProbes[level]), positions);
        for (std::size_t i = 0; i < distances.size(); ++i) points.features[i][Depth2 + level] = -distances[i];
    }
    for (std::size_t i = 0; i < points.voxels.size(); ++i) {
        const double depth = -space.outer[points.voxels[i]];
        points.features[i][Depth10] = depth;
        points.features[i][LimitedDepth10] = std::clamp(depth, 0.0, kLimit);
    }
}

void add_averages(const PocketSpace& space, RankedPoints& points) {
    const auto averages = [&](PointFeature feature, std::span<const double> values, double sigma) {
        const std::vector<double> found = gaussian_average(space, values, sigma);
        for (std::size_t i = 0; i < points.voxels.size(); ++i) points.features[i][feature] = found[points.voxels[i]];
    };
    std::vector<double> narrow(space.size());
    std::vector<double> wide(space.size());
    std::vector<double> depths(space.size());
    for (std::size_t i = 0; i < points.voxels.size(); ++i) {
        wide[points.voxels[i]] = 1.0;
        if (points.features[i][Depth2 + kNarrow] > 0.0) narrow[points.voxels[i]] = 1.0;
    }
    for (VoxelId v = 0; v < space.size(); ++v)
        if (space.is_within(v)) depths[v] = std::min(-space.outer[v], kMostDepth);
    averages(NarrowShare, narrow, 1.5);
    averages(MediumShare, narrow, 3.0);
    averages(WideShare, wide, 5.0);
    averages(NarrowDepth, depths, 2.0);
    averages(WideDepth, depths, 4.0);
    for (PointFeatures& features : points.features)
        features[MediumShare2] = features[MediumShare] * features[MediumShare];
}

}  // namespace

RankedPoints rank_points(const PocketSpace& space, const AccessibleSurface& small, const Atoms& atoms,
                         std::span<const AtomClass> classes) {
    const Neighbourhood neighbourhood(small.data().atoms, classes);
    RankedPoints points{clear_voxels(space, neighbourhood), {}};
    points.features.resize(points.voxels.size());
    for_each_block(space, points.voxels, neighbourhood, kFarthest, [&](std::size_t i, std::span<const Neighbour> near) {
        add_neighbours(space.position(points.voxels[i]), near, points.features[i]);
    });
    add_depths(space, atoms, points);
    add_averages(space, points);
    return points;
}

}  // namespace meniscus
