// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/distance_band.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>

#include "band/block_groups.h"
#include "band/block_units.h"
#include "core/bits.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

using Claim = BlockUnits::Claim;

constexpr auto kAllNodes = [] {
    std::array<std::uint32_t, kUnitNodes> nodes{};
    std::iota(nodes.begin(), nodes.end(), 0U);
    return nodes;
}();

// Calls visit(node of the unit, node of the block) for the first node of each row along x.
template <class Visit>
void for_each_row(int unit, const Visit& visit) {
    const auto number = [](int node) { return static_cast<std::size_t>(node); };
    const std::size_t first = kUnitEdge * number(node_in_block(unit & 1, unit >> 1 & 1, unit >> 2));
    for (int z = 0; z < kUnitEdge; ++z)
        for (int y = 0; y < kUnitEdge; ++y)
            visit(number(node_in_unit(0, y, z)), first + number(node_in_block(0, y, z)));
}

// Where the samples of one block go.
struct BlockSamples {
    std::span<float, kBlockNodes> distance;
    std::span<float, kBlockNodes> curvature;
};

BlockSamples samples_of(DistanceBand& band, BlockId block) {
    const std::size_t first = std::size_t{block} * kBlockNodes;
    return {std::span<float, kBlockNodes>(band.distance.data() + first, kBlockNodes),
            std::span<float, kBlockNodes>(band.curvature.data() + first, kBlockNodes)};
}

// Evaluates all nodes of one block after the other.
class BlockDistance {
public:
    BlockDistance(const AccessibleSurface& surface, double spacing, double margin)
        : units_(surface, spacing, margin), spacing_(spacing), margin_(margin) {}

    // around: features for a box around the block; corner: position of node (0, 0, 0)
    void evaluate(const LocalFeatures& around, const Vec3& corner, const BlockSamples& samples) {
        units_.enter_block(around, corner);
        for (int u = 0; u < kUnits; ++u) {
            const Claim side = units_.enter_unit(u);
            if (side == Claim::Below || side == Claim::Above) {
                fill_unit(u, side, samples);
            } else {
                sample_points(nodes_within());
                write_unit(u, samples);
            }
        }
    }

private:
    void fill_unit(int unit, Claim side, const BlockSamples& samples) const {
        const auto distance = static_cast<float>(side == Claim::Below ? -margin_ : margin_);
        for_each_row(unit, [&](std::size_t, std::size_t node) {
            std::fill_n(&samples.distance[node], kUnitEdge, distance);
            std::fill_n(&samples.curvature[node], kUnitEdge, 0.0F);
        });
    }

    // Nodes that may be within the margin. Others get the margin of their side.
    std::span<const std::uint32_t> nodes_within() {
        const auto [inside, settled] = units_.screen();
        if (settled == 0) return kAllNodes;
        for (std::size_t n = 0; n < kUnitNodes; ++n)
            distances_[n] = static_cast<float>((inside >> n & 1U) != 0 ? -margin_ : margin_);
        std::fill_n(curvatures_, kUnitNodes, 0.0F);
        const UnitBits within = ~settled;
        return {nodes_, list_items(&within, kUnitNodes, nodes_)};
    }

    void sample_points(std::span<const std::uint32_t> nodes) {
        if (nodes.empty()) return;
        units_.search(nodes);
        units_.batch().find_curvatures();
        units_.batch().write(nodes, 1.0 / spacing_, distances_, curvatures_);
    }

    void write_unit(int unit, const BlockSamples& samples) const {
        for_each_row(unit, [&](std::size_t point, std::size_t node) {
            std::copy_n(distances_ + point, kUnitEdge, &samples.distance[node]);
            std::copy_n(curvatures_ + point, kUnitEdge, &samples.curvature[node]);
        });
    }

    BlockUnits units_;
    double spacing_;
    double margin_;
    float distances_[kUnitNodes];  // of the unit's nodes
    float curvatures_[kUnitNodes];
    std::uint32_t nodes_[kUnitNodes];  // those that may be within the margin
};

}  // namespace

DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin) {
    DistanceBand band;
    band.margin = margin;
    resize_touched(band.distance, grid.node_count());
    resize_touched(band.curvature, grid.node_count());
    for_each_block(
        grid, LocalFeatures(surface, BlockUnits::reach(grid.spacing(), margin)),
        [&] { return std::make_unique<BlockDistance>(surface, grid.spacing(), margin); },
        [&](BlockDistance& evaluator, const LocalFeatures& around, BlockId b) {
            evaluator.evaluate(around, grid.corner(b), samples_of(band, b));
        });
    return band;
}

}  // namespace meniscus
