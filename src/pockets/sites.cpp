// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/sites.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <numeric>

#include "core/parallel.h"
#include "meniscus/measures.h"
#include "pockets/voxel_neighbours.h"

namespace meniscus {
namespace {

constexpr double kLeast = 0.05;      // of the largest probability: of points that count
constexpr double kKernel = 8.0;      // Å: how far points add to a density
constexpr double kSeparation = 8.0;  // Å around a site's centre: points that are taken away
constexpr double kSeed = 4.0;        // Å around a site's centre: where its basin begins
constexpr double kBody = 0.5;        // of the largest density of a basin: the least one of a region

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

    /// Of the points in blocks within the kernel's reach of a block, in ascending order.
    WeightedPlaces near(const BlockCoord& block) const {
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

// For each voxel the site whose basin begins there, or kNone.
std::vector<std::uint32_t> seeds(const PocketSpace& space, std::span<const double> densities,
                                 std::span<const Site> sites, std::span<const std::uint8_t> left_out) {
    std::vector<std::uint32_t> result(space.size(), kNone);
    for (std::uint32_t s = 0; s < sites.size(); ++s) {
        VoxelId best = kNoVoxel;
        for (VoxelId v = 0; v < space.size(); ++v) {
            if (left_out[v] != 0 || result[v] != kNone) continue;
            if (squared_norm(space.position(v) - sites[s].centre) > kSeed * kSeed) continue;
            if (best == kNoVoxel || densities[v] > densities[best]) best = v;
        }
        if (best != kNoVoxel) result[best] = s;
    }
    return result;
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

std::vector<double> densities(const PocketSpace& space, const WeightedPoints& points) {
    std::vector<double> result(space.size());
    const PointBlocks blocks(space, points);
    std::vector<VoxelId> begins;
    for (VoxelId v = 0; v < space.size(); ++v)
        if (v == 0 || space.nodes[v] / kBlockNodes != space.nodes[v - 1] / kBlockNodes) begins.push_back(v);
    const auto count = static_cast<VoxelId>(space.size());
    parallel_for(begins.size(), 1, [&](std::size_t b) {
        const WeightedPlaces near = blocks.near(space.grid.coord(space.nodes[begins[b]] / kBlockNodes));
        const VoxelId end = b + 1 < begins.size() ? begins[b + 1] : count;
        for (VoxelId v = begins[b]; v < end; ++v) result[v] = density_at(space.position(v), near);
    });
    return result;
}

std::vector<Site> find_sites(const PocketSpace& space, const WeightedPoints& points, std::size_t most) {
    WeightedPlaces places{{}, points.weights};
    for (const VoxelId v : points.voxels) places.positions.push_back(space.position(v));
    const std::vector<double> everywhere = densities(space, points);
    std::vector<double> scores;
    for (const VoxelId v : points.voxels) scores.push_back(everywhere[v]);
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
        sites.push_back({scores[best], (1.0 / sum) * moment, points.voxels[best]});
        WeightedPlaces removed;
        for (std::size_t i = 0; i < scores.size(); ++i) {
            if (squared_norm(places.positions[i] - sites.back().centre) > kSeparation * kSeparation) continue;
            candidate[i] = 0;
            if (places.weights[i] == 0.0) continue;
            removed.positions.push_back(places.positions[i]);
            removed.weights.push_back(places.weights[i]);
            places.weights[i] = 0.0;
        }
        candidate[best] = 0;
        parallel_for(scores.size(), 256, [&](std::size_t i) {
            constexpr double kReach = kSeparation + kKernel;
            if (squared_norm(places.positions[i] - sites.back().centre) > kReach * kReach) return;
            scores[i] -= density_at(places.positions[i], removed);
        });
    }
    return sites;
}

std::vector<std::uint32_t> regions(const PocketSpace& space, std::span<const double> densities,
                                   std::span<const Site> sites, std::span<const std::uint8_t> left_out) {
    std::vector<std::uint32_t> basins = seeds(space, densities, sites, left_out);
    std::vector<VoxelId> order(space.size());
    std::iota(order.begin(), order.end(), VoxelId{0});
    std::stable_sort(order.begin(), order.end(), [&](VoxelId a, VoxelId b) { return densities[a] > densities[b]; });
    std::vector<double> highest(sites.size());
    for (const VoxelId v : order) {
        if (left_out[v] != 0 || densities[v] <= 0.0) continue;
        if (basins[v] == kNone) {
            VoxelId best = kNoVoxel;
            for_each_neighbour(space, v, [&](VoxelId other) {
                if (basins[other] == kNone || densities[other] < densities[v]) return;
                if (best == kNoVoxel || densities[other] > densities[best]) best = other;
            });
            if (best != kNoVoxel) basins[v] = basins[best];
        }
        if (basins[v] != kNone) highest[basins[v]] = std::max(highest[basins[v]], densities[v]);
    }
    for (VoxelId v = 0; v < space.size(); ++v)
        if (basins[v] != kNone && densities[v] < kBody * highest[basins[v]]) basins[v] = kNone;
    return basins;
}

}  // namespace meniscus
