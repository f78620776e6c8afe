// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/sides.h"

#include <cstdint>
#include <memory>
#include <span>

#include "band/block_groups.h"
#include "band/block_units.h"

namespace meniscus {
namespace {

using Claim = BlockUnits::Claim;

constexpr double kMargin = 1e-6;  // Å: nobody asks for distances, but a search wants one

// Finds the sides of all nodes of one block after the other.
class BlockSides {
public:
    BlockSides(const AccessibleSurface& surface, double spacing) : units_(surface, spacing, kMargin) {}

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
        units_.batch().list_insides(units_.slack(), atoms_);
        auto [inside, settled] = units_.screen(atoms_);
        const UnitBits open = ~settled;
        const std::size_t count = list_items(&open, kUnitNodes, nodes_);
        if (count == 0) return inside;
        units_.search(std::span(nodes_).first(count));
        for (std::size_t i = 0; i < count; ++i) inside |= UnitBits{units_.batch().is_inside(i)} << nodes_[i];
        return inside;
    }

    BlockUnits units_;
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
