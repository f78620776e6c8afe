// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/sides.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <vector>

#include "band/block_groups.h"
#include "band/side_kernels.h"
#include "band/unit_places.h"
#include "core/bits.h"
#include "geometry/accessible_surface_data.h"
#include "nearest/nearest_batch.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr double kMargin = 1e-6;  // Å: a search needs a margin, though only signs are asked for

// Å: no length that decides is longer. From the middle of a block to a point it is half a diagonal; from there to the
// centre of a ball less than its radius and, in K, what a unit's middle may be deep there with nodes outside K; to an
// arc or a vertex no more than what puts a unit inside, and from an arc to its centre less than a ball's radius. What
// is farther is off by more, but by far less than it is too far to decide.
double longest_length(const AccessibleSurface::Data& data, double spacing) {
    return half_diagonal(kBlockEdge, spacing) + data.rho_max +
           std::max(data.rho_max, data.probe + half_diagonal(kUnitEdge, spacing));
}

// Where what is within `radius` is to have its side, of points up to `reach` from their middle. What rounding takes
// from half diagonals, which these are, is far less than the slack.
SideLimits limits_of(const AccessibleSurface::Data& data, double spacing, double radius, double reach) {
    return {data.probe, radius, reach, longest_length(data, spacing)};
}

// From the middle of a block to the farthest middle of a unit, Å.
double to_units(double spacing) { return half_diagonal(kBlockEdge, spacing) - half_diagonal(kUnitEdge, spacing); }

// What is the same for all blocks.
struct SideSearch {
    SideCaps caps;
    double spacing;
    SideLimits unit_limits;
    SideLimits node_limits;
    double margin;                   // of the features, Å
    LanePoints<float> unit_middles;  // from the middle of a block
    LanePoints<float> nodes;         // from the middle of a unit

    SideSearch(const AccessibleSurface::Data& data, double of_spacing)
        : caps(data),
          spacing(of_spacing),
          unit_limits(limits_of(data, spacing, half_diagonal(kUnitEdge, spacing), to_units(spacing))),
          node_limits(limits_of(data, spacing, 0.0, half_diagonal(kUnitEdge, spacing))),
          margin(unit_limits.far + unit_limits.slack - data.probe) {
        for (std::size_t u = 0; u < kUnits; ++u)
            set_point(unit_middles, u, spacing * (unit_steps(u) + to_middle(kUnitEdge) - to_middle(kBlockEdge)));
        for (std::size_t n = 0; n < kUnitNodes; ++n)
            set_point(nodes, n, spacing * (node_steps(n) - to_middle(kUnitEdge)));
    }
};

// Finds the sides of all nodes of one block after the other, reusing its memory.
class BlockSides {
public:
    BlockSides(const AccessibleSurface& surface, const SideSearch& search) : search_(search), batch_(surface) {}

    // around: features for a box around the block; corner: position of node (0, 0, 0)
    InsideBits evaluate(const LocalFeatures& around, const Vec3& corner) {
        InsideBits bits{};
        gatherer_.gather(around, box_of_nodes(corner, kBlockEdge, search_.spacing), search_.margin, block_);
        if (block_.features.balls.size() == 0) return bits;
        const auto [inside, settled] = side_kernels().settle(search_.caps, block_.features, search_.unit_limits,
                                                             search_.unit_middles, kUnits, work_);
        std::int32_t deepest[kUnits];  // the ball where the middle of a unit is deepest
        std::copy_n(work_.deepest.at, kUnits, deepest);
        for (std::size_t u = 0; u < kUnits; ++u) {
            if ((inside >> u & 1U) != 0) bits[u] = ~UnitBits{0};
            if ((settled >> u & 1U) != 0) continue;
            const auto [nodes_inside, nodes_settled] = settle_nodes(u, static_cast<std::size_t>(deepest[u]));
            bits[u] = nodes_inside;
            if (~nodes_settled != 0)
                bits[u] |= inside_exactly(~nodes_settled, around, corner + search_.spacing * unit_steps(u));
        }
        return bits;
    }

private:
    KnownSides settle_nodes(std::size_t unit, std::size_t deepest) {
        const SideCube cube{{search_.unit_middles.x[unit], search_.unit_middles.y[unit], search_.unit_middles.z[unit]},
                            static_cast<float>(0.5 * (kUnitEdge - 1) * search_.spacing)};
        side_kernels().choose(block_, cube, search_.node_limits, deepest, unit_);
        return side_kernels().settle(search_.caps, unit_, search_.node_limits, search_.nodes, kUnitNodes, work_);
    }

    // Of nodes of a unit that are in doubt in single precision. corner: position of its first node
    UnitBits inside_exactly(UnitBits nodes, const LocalFeatures& around, const Vec3& corner) {
        const NearestBatch::Claim all = batch_.start(around, box_of_nodes(corner, kUnitEdge, search_.spacing), kMargin);
        if (all != NearestBatch::Claim::Open) return all == NearestBatch::Claim::Below ? nodes : 0;
        points_.clear();
        for_each_bit(nodes, [&](std::size_t n) { points_.push_back(corner + search_.spacing * node_steps(n)); });
        batch_.find(points_);
        UnitBits inside = 0;
        std::size_t i = 0;
        for_each_bit(nodes, [&](std::size_t n) { inside |= UnitBits{batch_.is_inside(i++)} << n; });
        return inside;
    }

    const SideSearch& search_;
    SideGatherer gatherer_;
    SideFeaturesOfBox block_;
    SideFeatures unit_;
    SideWork work_;
    NearestBatch batch_;
    std::vector<Vec3> points_;
};

}  // namespace

std::vector<InsideBits> find_sides(const AccessibleSurface& surface, const BlockGrid& grid) {
    std::vector<InsideBits> sides;
    resize_touched(sides, grid.block_count());
    const SideSearch search(surface.data(), grid.spacing());
    for_each_block(
        grid, LocalFeatures(surface, search.margin), [&] { return std::make_unique<BlockSides>(surface, search); },
        [&](BlockSides& evaluator, const LocalFeatures& around, BlockId b) {
            sides[b] = evaluator.evaluate(around, grid.corner(b));
        });
    return sides;
}

}  // namespace meniscus
