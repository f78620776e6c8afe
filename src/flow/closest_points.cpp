// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/closest_points.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>

#include "core/parallel.h"
#include "meniscus/level_set.h"

namespace meniscus {
namespace {

// A point of the zero set next to a node with a neighbour of the other sign; nodes refer to seeds by number.
using SeedId = std::uint32_t;
constexpr SeedId kNoSeed = 0xffffffffU;
constexpr std::size_t kGrain = 16;  // blocks per task

int padded_entry(int x, int y, int z) { return (x + 1) + kPaddedEdge * ((y + 1) + kPaddedEdge * (z + 1)); }

template <class Visit>
void for_each_node_of_block(const Visit& visit) {
    for (int z = 0; z < kBlockEdge; ++z)
        for (int y = 0; y < kBlockEdge; ++y)
            for (int x = 0; x < kBlockEdge; ++x) visit(node_in_block(x, y, z), padded_entry(x, y, z));
}

class ClosestPoints {
public:
    ClosestPoints(const BlockGrid& grid, std::span<const float> values, std::span<const float> coefficients)
        : grid_(grid),
          values_(values),
          level_set_(std::shared_ptr<const BlockGrid>(std::shared_ptr<void>(), &grid), coefficients),
          seed_of_(values.size(), kNoSeed),
          next_(values.size(), kNoSeed) {
        find_seeds();
    }

    // Hands every seed on to the 26 neighbours of the nodes that have it; each node keeps the nearest.
    void spread() {
        parallel_for(grid_.block_count(), kGrain, [&](std::size_t b) { spread_into(static_cast<BlockId>(b)); });
        std::swap(seed_of_, next_);
    }

    NodeField distances(double width) const {
        NodeField result(values_.size(), 0.0F);
        parallel_for(values_.size(), kBlockNodes, [&](std::size_t n) {
            double distance = width;
            const Vec3 p = grid_.position(n);
            if (seed_of_[n] != kNoSeed && norm(seeds_[seed_of_[n]] - p) < width + grid_.spacing())
                distance = std::min(width, distance_from_seed(p, seeds_[seed_of_[n]]));
            result[n] = static_cast<float>(values_[n] < 0.0F ? -distance : distance);
        });
        return result;
    }

private:
    double distance_from_seed(const Vec3& p, const Vec3& seed) const {
        const double distance = norm(level_set_.closest_point(p, seed) - p);
        return std::isnan(distance) ? norm(seed - p) : distance;
    }

    void find_seeds() {
        std::vector<std::vector<std::uint16_t>> cut(grid_.block_count());
        parallel_for(cut.size(), kGrain, [&](std::size_t b) { find_cut_nodes(static_cast<BlockId>(b), cut[b]); });
        std::vector<std::size_t> first(cut.size() + 1, 0);
        for (std::size_t b = 0; b < cut.size(); ++b) first[b + 1] = first[b] + cut[b].size();
        seeds_.resize(first.back());
        parallel_for(cut.size(), kGrain, [&](std::size_t b) {
            for (std::size_t k = 0; k < cut[b].size(); ++k) {
                const std::size_t n = b * kBlockNodes + cut[b][k];
                seed_of_[n] = static_cast<SeedId>(first[b] + k);
                seeds_[seed_of_[n]] = level_set_.project(grid_.position(n));
            }
        });
    }

    void find_cut_nodes(BlockId block, std::vector<std::uint16_t>& cut) const {
        const auto padded = gather_padded<float>(grid_, values_, block, std::numeric_limits<float>::quiet_NaN());
        for_each_node_of_block([&](int node, int entry) {
            const float own = padded[static_cast<std::size_t>(entry)];
            for (const int step : {1, kPaddedEdge, kPaddedEdge * kPaddedEdge})
                for (const int beside : {entry - step, entry + step}) {
                    const float other = padded[static_cast<std::size_t>(beside)];
                    if (!std::isnan(other) && (other < 0.0F) != (own < 0.0F)) {
                        cut.push_back(static_cast<std::uint16_t>(node));
                        return;
                    }
                }
        });
    }

    void spread_into(BlockId block) {
        const auto padded = gather_padded<SeedId>(grid_, seed_of_, block, kNoSeed);
        const std::size_t first = std::size_t{block} * kBlockNodes;
        if (std::all_of(padded.begin(), padded.end(), [](SeedId seed) { return seed == kNoSeed; })) {
            std::fill_n(next_.begin() + static_cast<std::ptrdiff_t>(first), kBlockNodes, kNoSeed);
            return;
        }
        for_each_node_of_block([&](int node, int entry) {
            const std::size_t n = first + static_cast<std::size_t>(node);
            next_[n] = nearest_around(grid_.position(n), padded, entry);
        });
    }

    SeedId nearest_around(const Vec3& p, const std::array<SeedId, kPaddedNodes>& padded, int entry) const {
        SeedId best = kNoSeed;
        double least = std::numeric_limits<double>::infinity();
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx) {
                    const int beside = entry + dx + kPaddedEdge * (dy + kPaddedEdge * dz);
                    const SeedId seed = padded[static_cast<std::size_t>(beside)];
                    if (seed == kNoSeed || seed == best) continue;
                    const double d2 = squared_norm(seeds_[seed] - p);
                    if (d2 < least || (d2 == least && seed < best)) {
                        least = d2;
                        best = seed;
                    }
                }
        return best;
    }

    const BlockGrid& grid_;
    std::span<const float> values_;
    LevelSet level_set_;
    std::vector<Vec3> seeds_;
    std::vector<SeedId> seed_of_;
    std::vector<SeedId> next_;
};

}  // namespace

NodeField distance_by_closest_points(const BlockGrid& grid, std::span<const float> values,
                                     std::span<const float> coefficients, double width) {
    ClosestPoints points(grid, values, coefficients);
    const int rounds = static_cast<int>(std::ceil(width / grid.spacing()));
    for (int round = 0; round < rounds; ++round) points.spread();
    return points.distances(width);
}

}  // namespace meniscus
