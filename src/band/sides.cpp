// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/sides.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <span>

#include "band/block_groups.h"
#include "band/block_units.h"

namespace meniscus {
namespace {

using Claim = BlockUnits::Claim;

constexpr double kMargin = 1e-6;  // Å: distances beyond are for nobody

// Finds the sides of all nodes of one block after the other.
class BlockSides {
public:
    BlockSides(const AccessibleSurface& surface, double spacing) : units_(surface, spacing, kMargin) {
        const double near = surface.probe() - units_.slack();
        if (near > 0.0) near_foot_ = static_cast<float>(near * near);
    }

    void enter(const Box& box) { units_.enter(box); }
    void enter_part(const Box& box) { units_.enter_part(box); }

    // corner: position of node (0, 0, 0)
    InsideBits evaluate(const Vec3& corner) {
        units_.enter_block(corner);
        InsideBits bits{};
        for (std::size_t u = 0; u < kUnits; ++u) {
            const Claim side = units_.enter_unit(static_cast<int>(u));
            if (side != Claim::Above) bits[u] = side == Claim::Below ? ~UnitBits{0} : inside_of_unit();
        }
        return bits;
    }

private:
    // What is known without a search settles most nodes.
    UnitBits inside_of_unit() {
        const BlockUnits::Middle& middle = units_.middle();
        SideScreen screen;
        screen.foot[0] = static_cast<float>(middle.to_foot.x);
        screen.foot[1] = static_cast<float>(middle.to_foot.y);
        screen.foot[2] = static_cast<float>(middle.to_foot.z);
        screen.near_foot = near_foot_;
        screen.near_middle = static_cast<float>(std::abs(middle.distance) - units_.slack());
        screen.middle_inside = middle.distance < 0.0;
        units_.batch().list_insides(units_.slack(), atoms_);
        auto [inside, settled] =
            nearest_kernels().screen_sides(screen, atoms_, units_.from_middle(), units_.lengths_from_middle());
        const UnitBits open = ~settled;
        const std::size_t count = list_items(&open, kUnitNodes, nodes_);
        if (count == 0) return inside;
        units_.search(std::span(nodes_).first(count));
        for (std::size_t i = 0; i < count; ++i) inside |= UnitBits{units_.batch().is_inside(i)} << nodes_[i];
        return inside;
    }

    BlockUnits units_;
    float near_foot_ = -1.0F;  // Å²: nodes so near to a point of K are outside
    std::vector<InsideBall> atoms_;
    std::uint32_t nodes_[kUnitNodes];  // of a unit, those that must be searched
};

}  // namespace

std::vector<InsideBits> find_sides(const AccessibleSurface& surface, const BlockGrid& grid) {
    std::vector<InsideBits> sides(grid.block_count());
    for_each_block(
        grid, [&] { return std::make_unique<BlockSides>(surface, grid.spacing()); },
        [&](BlockSides& evaluator, BlockId b) { sides[b] = evaluator.evaluate(grid.corner(b)); });
    return sides;
}

}  // namespace meniscus
