// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Signs of a sampled function as bits: which grid edges and cells of a block the zero set cuts.
//
// A vertex of the mesh belongs to a cut edge, which belongs to its node nearer to the block's corner. Vertices are
// numbered by block, direction and bit, so a number is an offset per block plus a count of bits: no hash.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "grid/block_grid.h"

namespace meniscus {

/// One bit per node of a block: bit x + 8 y of word z.
using NodeBits = std::array<std::uint64_t, kBlockEdge>;

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

/// Inside bits of a block and of the nodes next to it on its upper sides. A missing block has no bits set.
struct Rows {
    std::array<std::uint16_t, kRowNodes * kRowNodes> inside{};  ///< bit x of row y + 9 z
    std::array<bool, 8> exists{};                               ///< by octant, see upper_neighbour
    std::array<std::uint8_t, 4> complete{};  ///< cells with eight nodes: bit x, by (y is 7) + 2 (z is 7)
    bool mixed = false;                      ///< some node differs from the others; else the rest is not filled in
};

/// Cut edges of a block, and how many vertices come before each word within the block.
struct CutEdges {
    std::array<NodeBits, 3> bits{};                               ///< by direction and the node nearer to the corner
    std::array<std::array<std::uint16_t, kBlockEdge>, 3> rank{};  ///< vertices before each word
    std::size_t first_vertex = 0;                                 ///< number of the block's first vertex
};

/// Calls visit(bit) for every bit that is set, in rising order.
template <class Visit>
void for_each_bit(std::uint64_t word, const Visit& visit) {
    for (; word != 0; word &= word - 1) visit(static_cast<std::size_t>(std::countr_zero(word)));
}

/// Calls visit(cell, case) for every cell of the block that has all its nodes and both signs: cell as local_node, case
/// the set of inside corners (mesh/cell_cases.h).
template <class Visit>
void for_each_cut_cell(const Rows& rows, const Visit& visit) {
    for (std::size_t z = 0; z < kBlockEdge; ++z)
        for (std::size_t y = 0; y < kBlockEdge; ++y) {
            const std::size_t row = y + kRowNodes * z;
            const unsigned a = rows.inside[row];
            const unsigned b = rows.inside[row + 1];
            const unsigned c = rows.inside[row + kRowNodes];
            const unsigned d = rows.inside[row + kRowNodes + 1];
            const unsigned any = a | b | c | d;
            const unsigned all = a & b & c & d;
            const std::size_t last = (y == kBlockEdge - 1 ? 1U : 0U) + (z == kBlockEdge - 1 ? 2U : 0U);
            for_each_bit((any | any >> 1U) & ~(all & all >> 1U) & rows.complete[last], [&](std::size_t x) {
                visit(local_node(x, y, z),
                      (a >> x & 3U) | (b >> x & 3U) << 2U | (c >> x & 3U) << 4U | (d >> x & 3U) << 6U);
            });
        }
}

/// Inside bits of all blocks: values below 0.
std::vector<NodeBits> inside_bits(const BlockGrid& grid, std::span<const float> values);

/// The rows of one block, given the inside bits of all.
Rows rows_of(const BlockGrid& grid, std::span<const NodeBits> inside, std::size_t block);

/// Cut edges of all blocks. One entry more than blocks: the last one's first_vertex is the total.
std::vector<CutEdges> find_cut_edges(const BlockGrid& grid, std::span<const NodeBits> inside);

}  // namespace meniscus
