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

constexpr double kMargin = 1e-6;  // Å: nobody asks for distances, but a search wants one

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

// Finds the sides of all nodes of one block after the other.
class BlockSides {
public:
    BlockSides(const AccessibleSurface& surface, const SideCaps& caps, double spacing)
        : caps_(caps),
          spacing_(spacing),
          unit_limits_(limits_of(surface.data(), spacing, half_diagonal(kUnitEdge, spacing), to_units(spacing))),
          node_limits_(limits_of(surface.data(), spacing, 0.0, half_diagonal(kUnitEdge, spacing))),
          margin_(unit_limits_.far + unit_limits_.slack - surface.data().probe),
          around_(surface, margin_),
          part_(surface, margin_),
          batch_(surface) {
        for (std::size_t u = 0; u < kUnits; ++u)
            put(unit_middles_, u, unit_steps(u) + to_middle(kUnitEdge) - to_middle(kBlockEdge));
        for (std::size_t n = 0; n < kUnitNodes; ++n) put(nodes_, n, node_steps(n) - to_middle(kUnitEdge));
    }

    void enter(const Box& box) { around_.gather(box); }
    void enter_part(const Box& box) { part_.gather_from(around_, box); }

    // corner: position of node (0, 0, 0)
    InsideBits evaluate(const Vec3& corner) {
        InsideBits bits{};
        gatherer_.gather(part_, box_of_nodes(corner, kBlockEdge, spacing_), margin_, block_);
        if (block_.features.balls.size() == 0) return bits;
        const auto [inside, settled] =
            kernels_.settle(caps_, block_.features, unit_limits_, unit_middles_, kUnits, work_);
        std::copy_n(work_.deepest.at, kUnits, deepest_);
        for (std::size_t u = 0; u < kUnits; ++u) {
            if ((inside >> u & 1U) != 0) bits[u] = ~UnitBits{0};
            if ((settled >> u & 1U) == 0) bits[u] = inside_of_unit(u, corner + spacing_ * unit_steps(u));
        }
        return bits;
    }

private:
    void put(LanePoints<float>& points, std::size_t i, const Vec3& steps) const {
        set_point(points, i, spacing_ * steps);
    }

    UnitBits inside_of_unit(std::size_t unit, const Vec3& corner) {
        const SideCube cube{{unit_middles_.x[unit], unit_middles_.y[unit], unit_middles_.z[unit]},
                            static_cast<float>(0.5 * (kUnitEdge - 1) * spacing_)};
        kernels_.choose(block_, cube, node_limits_, static_cast<std::size_t>(deepest_[unit]), unit_features_);
        const auto [inside, settled] = kernels_.settle(caps_, unit_features_, node_limits_, nodes_, kUnitNodes, work_);
        return ~settled == 0 ? inside : inside | inside_exactly(~settled, corner);
    }

    // Of nodes that are in doubt in single precision.
    UnitBits inside_exactly(UnitBits nodes, const Vec3& corner) {
        const NearestBatch::Claim all = batch_.start(part_, box_of_nodes(corner, kUnitEdge, spacing_), kMargin);
        if (all != NearestBatch::Claim::Open) return all == NearestBatch::Claim::Below ? nodes : 0;
        points_.clear();
        for_each_bit(nodes, [&](std::size_t n) { points_.push_back(corner + spacing_ * node_steps(n)); });
        batch_.find(points_);
        UnitBits inside = 0;
        std::size_t i = 0;
        for_each_bit(nodes, [&](std::size_t n) { inside |= UnitBits{batch_.is_inside(i++)} << n; });
        return inside;
    }

    const SideCaps& caps_;
    const SideKernels& kernels_ = side_kernels();
    double spacing_;
    SideLimits unit_limits_;
    SideLimits node_limits_;
    double margin_;                   // of what is gathered, Å
    LanePoints<float> unit_middles_;  // from the middle of a block
    LanePoints<float> nodes_;         // from the middle of a unit
    LocalFeatures around_;            // of many blocks
    LocalFeatures part_;              // of fewer of them
    SideGatherer gatherer_;
    SideFeaturesOfBox block_;
    SideFeatures unit_features_;
    SideWork work_;
    std::int32_t deepest_[kUnits];  // the ball where the middle of a unit is deepest
    NearestBatch batch_;
    std::vector<Vec3> points_;
};

}  // namespace

std::vector<InsideBits> find_sides(const AccessibleSurface& surface, const BlockGrid& grid) {
    std::vector<InsideBits> sides;
    resize_touched(sides, grid.block_count());
    const SideCaps caps(surface.data());
    for_each_block(
        grid, [&] { return std::make_unique<BlockSides>(surface, caps, grid.spacing()); },
        [&](BlockSides& evaluator, BlockId b) { sides[b] = evaluator.evaluate(grid.corner(b)); });
    return sides;
}

}  // namespace meniscus
