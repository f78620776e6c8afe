// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/sites.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "core/parallel.h"
#include "meniscus/measures.h"
#include "pockets/voxel_neighbours.h"

namespace meniscus {
namespace {

constexpr double kLeast = 0.05;      // of the largest probability: of points that count
constexpr double kKernel = 8.0;      // Å: how far points add to a density
constexpr double kSeparation = 8.0;  // Å around a site's centre: points that are taken away
constexpr double kBody = 0.5;        // of a site's largest density: the least one of its region

// What a point adds to the density at a squared distance from it.
double kernel(double squared_distance) { return std::max(0.0, 1.0 - squared_distance / (kKernel * kKernel)); }

struct WeightedPlaces {
    std::vector<Vec3> positions;
    std::vector<double> weights;
};

// Points of each block that has any, and the points around it.
class PointBlocks {
public:
    PointBlocks(const PocketSpace& space, const WeightedPoints& points) : space_(space), points_(points) {
        for (std::size_t i = 0; i < points.voxels.size(); ++i) {
            const BlockCoord& at = space.grid.coord(space.nodes[points.voxels[i]] / kBlockNodes);
            if (blocks_.empty() || blocks_.back() != at) {
                blocks_.push_back(at);
                begins_.push_back(i);
            }
        }
        begins_.push_back(points.voxels.size());
    }

    std::size_t size() const { return blocks_.size(); }

    template <class Visit>
    void for_each_point(std::size_t number, const Visit& visit) const {
        for (std::size_t i = begins_[number]; i < begins_[number + 1]; ++i) visit(i);
    }

    /// The points in blocks within the kernel's reach of a block, in ascending order.
    WeightedPlaces near(std::size_t number) const {
        const BlockCoord& block = blocks_[number];
        const double edge = kBlockEdge * space_.grid.spacing();
        const auto reach = static_cast<std::int32_t>(kKernel / edge) + 1;
        WeightedPlaces result;
        for (std::int32_t dz = -reach; dz <= reach; ++dz)
            for (std::int32_t dy = -reach; dy <= reach; ++dy) {
                const BlockCoord first{.z = block.z + dz, .y = block.y + dy, .x = block.x - reach};
                const BlockCoord last{.z = first.z, .y = first.y, .x = block.x + reach};
                auto at = std::lower_bound(blocks_.begin(), blocks_.end(), first);
                for (; at != blocks_.end() && *at <= last; ++at)
                    append(static_cast<std::size_t>(at - blocks_.begin()), result);
            }
        return result;
    }

private:
    void append(std::size_t block, WeightedPlaces& to) const {
        for (std::size_t i = begins_[block]; i < begins_[block + 1]; ++i) {
            to.positions.push_back(space_.position(points_.voxels[i]));
            to.weights.push_back(points_.weights[i]);
        }
    }

    const PocketSpace& space_;
    const WeightedPoints& points_;
    std::vector<BlockCoord> blocks_;
    std::vector<std::size_t> begins_;
};

double density_at(const Vec3& point, const WeightedPlaces& places) {
    double sum = 0.0;
    for (std::size_t i = 0; i < places.positions.size(); ++i)
        sum += places.weights[i] * kernel(squared_norm(point - places.positions[i]));
    return sum;
}

WeightedPlaces places_of(const PocketSpace& space, const WeightedPoints& points) {
    WeightedPlaces places{{}, points.weights};
    for (const VoxelId v : points.voxels) places.positions.push_back(space.position(v));
    return places;
}

std::vector<double> densities(const PocketSpace& space, const WeightedPoints& points) {
    std::vector<double> result(points.voxels.size());
    const PointBlocks blocks(space, points);
    parallel_for(blocks.size(), 1, [&](std::size_t b) {
        const WeightedPlaces near = blocks.near(b);
        blocks.for_each_point(b,
                              [&](std::size_t i) { result[i] = density_at(space.position(points.voxels[i]), near); });
    });
    return result;
}

// Takes their label from voxels that do not hang together with the densest one of their site.
void keep_connected(const PocketSpace& space, std::span<const VoxelId> tops, std::vector<std::uint32_t>& labels) {
    std::vector<std::uint8_t> reached(space.size());
    std::vector<VoxelId> open;
    for (const VoxelId top : tops) {
        if (top == kNoVoxel) continue;
        reached[top] = 1;
        open.push_back(top);
    }
    while (!open.empty()) {
        const VoxelId voxel = open.back();
        open.pop_back();
        for_each_neighbour(space, voxel, [&](VoxelId other) {
            if (reached[other] != 0 || labels[other] != labels[voxel]) return;
            reached[other] = 1;
            open.push_back(other);
        });
    }
    for (VoxelId v = 0; v < space.size(); ++v)
        if (reached[v] == 0) labels[v] = kNone;
}

}  // namespace

WeightedPoints weighted_points(std::span<const VoxelId> voxels, std::span<const double> probabilities) {
    WeightedPoints points;
    if (voxels.empty()) return points;
    const double least = kLeast * *std::max_element(probabilities.begin(), probabilities.end());
    for (std::size_t i = 0; i < voxels.size(); ++i) {
        if (probabilities[i] < least) continue;
        points.voxels.push_back(voxels[i]);
        points.weights.push_back(probabilities[i] * probabilities[i]);
    }
    return points;
}

std::vector<Site> find_sites(const PocketSpace& space, const WeightedPoints& points, std::size_t most) {
    WeightedPlaces places = places_of(space, points);
    std::vector<double> scores = densities(space, points);
    std::vector<std::uint8_t> candidate(scores.size(), 1);
    std::vector<Site> sites;
    while (sites.size() < most) {
        std::size_t best = scores.size();
        for (std::size_t i = 0; i < scores.size(); ++i)
            if (candidate[i] != 0 && (best == scores.size() || scores[i] > scores[best])) best = i;
        if (best == scores.size() || scores[best] <= 0.0) break;
        double sum = 0.0;
        Vec3 moment;
        for (std::size_t i = 0; i < scores.size(); ++i) {
            if (squared_norm(places.positions[i] - places.positions[best]) > kKernel * kKernel) continue;
            sum += places.weights[i];
            moment += places.weights[i] * places.positions[i];
        }
        if (sum <= 0.0) break;
        Site site{scores[best], (1.0 / sum) * moment, points.voxels[best], {}};
        candidate[best] = 0;
        for (std::size_t i = 0; i < scores.size(); ++i) {
            if (squared_norm(places.positions[i] - site.centre) > kSeparation * kSeparation) continue;
            candidate[i] = 0;
            if (places.weights[i] == 0.0) continue;
            site.points.voxels.push_back(points.voxels[i]);
            site.points.weights.push_back(std::exchange(places.weights[i], 0.0));
        }
        const WeightedPlaces removed = places_of(space, site.points);
        parallel_for(scores.size(), 256, [&](std::size_t i) {
            constexpr double kReach = kSeparation + kKernel;
            if (squared_norm(places.positions[i] - site.centre) <= kReach * kReach)
                scores[i] -= density_at(places.positions[i], removed);
        });
        sites.push_back(std::move(site));
    }
    return sites;
}

double largest_density(const PocketSpace& space, const WeightedPoints& points, std::span<const VoxelId> voxels) {
    const WeightedPlaces places = places_of(space, points);
    std::vector<double> found(voxels.size());
    parallel_for(voxels.size(), 64, [&](std::size_t i) { found[i] = density_at(space.position(voxels[i]), places); });
    return found.empty() ? 0.0 : *std::max_element(found.begin(), found.end());
}

std::vector<std::uint32_t> regions(const PocketSpace& space, std::span<const Site> sites,
                                   std::span<const std::uint8_t> left_out) {
    constexpr double kReach = kSeparation + kKernel;
    std::vector<std::uint32_t> labels(space.size(), kNone);
    std::vector<double> highest(space.size());
    std::vector<VoxelId> tops(sites.size(), kNoVoxel);  // where each site is densest
    for (std::uint32_t s = 0; s < sites.size(); ++s) {
        const WeightedPlaces places = places_of(space, sites[s].points);
        parallel_for(space.size(), 1024, [&](std::size_t v) {
            const Vec3 point = space.position(static_cast<VoxelId>(v));
            if (left_out[v] != 0 || squared_norm(point - sites[s].centre) > kReach * kReach) return;
            const double density = density_at(point, places);
            if (density <= highest[v]) return;
            highest[v] = density;
            labels[v] = s;
        });
    }
    for (VoxelId v = 0; v < space.size(); ++v)
        if (labels[v] != kNone && (tops[labels[v]] == kNoVoxel || highest[v] > highest[tops[labels[v]]]))
            tops[labels[v]] = v;
    for (VoxelId v = 0; v < space.size(); ++v)
        if (labels[v] != kNone && highest[v] < kBody * highest[tops[labels[v]]]) labels[v] = kNone;
    keep_connected(space, tops, labels);
    return labels;
}

}  // namespace meniscus
