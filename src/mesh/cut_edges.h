// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Signs of a sampled function as bits: which grid edges and cells of a block the zero set cuts.
//
// A vertex of the mesh belongs to a cut edge, which belongs to its node nearer to the block's corner. Vertices are
// numbered by block, direction and bit, so a number is an offset per block plus a count of bits: no hash.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bits.h"
#include "grid/block_grid.h"
#include "grid/inside_bits.h"

namespace meniscus {

/// Nodes along each edge of a block, with the first ones of its upper neighbours.
inline constexpr std::size_t kRowNodes = kBlockEdge + 1;

/// Number of a node in a block or next to it on its upper sides; x, y, z in 0..8. Also the number of a cell.
constexpr std::size_t local_node(std::size_t x, std::size_t y, std::size_t z) {
    return x + kRowNodes * (y + kRowNodes * z);
}
inline constexpr std::size_t kLocalNodes = kRowNodes * kRowNodes * kRowNodes;

/// The block beside `around`'s middle one: octant = dx + 2 dy + 4 dz for dx, dy, dz in {0, 1}.
constexpr BlockId upper_neighbour(const std::array<BlockId, 27>& around, std::size_t octant) {
    const int i = static_cast<int>(octant);
    return around[static_cast<std::size_t>(neighbour_slot(i & 1, (i >> 1) & 1, i >> 2))];
}

/// Inside bits of a block's units and of those next to it on its upper sides. A missing block has no bits set.
struct UnitsAround {
    static constexpr std::size_t kEdge = 3;                ///< units along each axis
    std::array<UnitBits, kEdge * kEdge * kEdge> inside{};  ///< number x + 3 y + 9 z
    std::array<bool, 8> exists{};                          ///< whether a block does, by octant, see upper_neighbour
    bool mixed = false;                                    ///< whether some node differs from the others
};

/// One bit per node of a block, layer by layer: bit x + 8 y of word z.
using LayerBits = std::array<std::uint64_t, kBlockEdge>;

/// Cut edges of a block, and how many vertices come before each word within the block.
struct CutEdges {
    std::array<LayerBits, 3> bits{};                              ///< by direction and the node nearer to the corner
    std::array<std::array<std::uint16_t, kBlockEdge>, 3> rank{};  ///< vertices before each word
    std::size_t first_vertex = 0;                                 ///< number of the block's first vertex
};

/// The cells of a unit: for each of their corners (number x + 2 y + 4 z) whether it is inside, bit by bit, and which of
/// them have all their nodes and both signs.
struct UnitCells {
    std::array<UnitBits, 8> corners;
    UnitBits cut;
};
UnitCells cells_of(const UnitsAround& units, std::size_t unit);

/// The inside corners of eight cells in a row of bits, a byte for each.
constexpr std::uint64_t cases_of(const UnitCells& cells, std::size_t first) {
    std::uint64_t corners = 0;
    for (std::size_t k = 0; k < 8; ++k) corners |= (cells.corners[k] >> first & 0xFFU) << (8 * k);
    return transposed(corners);
}

/// Calls visit(cell, case) for every cell of the block that has all its nodes and both signs, row by row: cell as
/// local_node, case the set of inside corners (mesh/cell_cases.h).
template <class Visit>
void for_each_cut_cell(const UnitsAround& units, const Visit& visit) {
    static_assert(kUnitEdge == 4);  // two halves of rows are a byte
    constexpr std::uint64_t kFirstHalf = 0xFFFFFFFFU;
    std::array<UnitCells, kUnits> cells;
    for (std::size_t unit = 0; unit < kUnits; ++unit) cells[unit] = cells_of(units, unit);
    for (std::size_t z = 0; z < kBlockEdge; ++z)
        for (std::size_t y = 0; y < kBlockEdge; y += 2) {
            const std::size_t first = 16 * (z % kUnitEdge) + 4 * (y % kUnitEdge);
            const UnitCells& left = cells[2 * (y / kUnitEdge) + 4 * (z / kUnitEdge)];
            const UnitCells& right = cells[2 * (y / kUnitEdge) + 4 * (z / kUnitEdge) + 1];
            const UnitBits left_cut = left.cut >> first & 0xFFU;
            const UnitBits right_cut = right.cut >> first & 0xFFU;
            if ((left_cut | right_cut) == 0) continue;
            const std::uint64_t left_cases = cases_of(left, first);
            const std::uint64_t right_cases = cases_of(right, first);
            const auto visit_row = [&](std::size_t row, UnitBits cut, std::uint64_t cases) {
                for_each_bit(cut, [&](std::size_t x) {
                    visit(local_node(x, row, z), static_cast<unsigned>(cases >> (8 * x) & 0xFFU));
                });
            };
            visit_row(y, (left_cut & 0xFU) | (right_cut & 0xFU) << 4U, (left_cases & kFirstHalf) | right_cases << 32U);
            visit_row(y + 1, left_cut >> 4U | (right_cut & 0xF0U), left_cases >> 32U | (right_cases & ~kFirstHalf));
        }
}

/// Inside bits of all blocks: values below 0.
std::vector<InsideBits> inside_bits(const BlockGrid& grid, std::span<const float> values);

/// The units in and around one block, given the inside bits of all.
UnitsAround units_around(const BlockGrid& grid, std::span<const InsideBits> inside, std::size_t block);

/// Cut edges of all blocks. One entry more than blocks: the last one's first_vertex is the total.
std::vector<CutEdges> find_cut_edges(const BlockGrid& grid, std::span<const InsideBits> inside);

}  // namespace meniscus
