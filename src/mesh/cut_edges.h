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

/// The same for bit x + 8 y of a layer.
constexpr std::size_t node_of_bit(std::size_t bit, std::size_t z) {
    return bit + bit / kBlockEdge + kRowNodes * kRowNodes * z;
}

/// The block beside `around`'s middle one: octant = dx + 2 dy + 4 dz for dx, dy, dz in {0, 1}.
constexpr BlockId upper_neighbour(const std::array<BlockId, 27>& around, std::size_t octant) {
    const int i = static_cast<int>(octant);
    return around[static_cast<std::size_t>(neighbour_slot(i & 1, (i >> 1) & 1, i >> 2))];
}

/// Bits of nodes or cells of a layer in its first column and row.
inline constexpr std::uint64_t kFirstColumn = 0x0101010101010101U;
inline constexpr std::uint64_t kFirstRow = 0xFF;

/// One bit per node of a block, layer by layer: bit x + 8 y of word z.
using LayerBits = std::array<std::uint64_t, kBlockEdge>;

/// Cut edges of a block, and how many vertices come before each word within the block.
struct CutEdges {
    std::array<LayerBits, 3> bits{};                              ///< by direction and the node nearer to the corner
    std::array<std::array<std::uint16_t, kBlockEdge>, 3> rank{};  ///< vertices before each word
    std::size_t first_vertex = 0;                                 ///< number of the block's first vertex

    /// Number of the vertex on the cut edge from a node along a direction.
    std::size_t vertex(std::size_t direction, std::size_t bit, std::size_t z) const {
        const std::uint64_t before = bits[direction][z] & first_bits(bit);
        return first_vertex + rank[direction][z] + count_bits(before);
    }
};

/// Which nodes are inside, of a block and next to it on its upper sides, and which cells have all their nodes.
struct NodesAround {
    /// Bit x + 8 y of word z: the nodes at (x + dx, y + dy, z), number dx + 2 dy. A missing block has no bits set.
    std::array<std::array<std::uint64_t, kRowNodes>, 4> inside;
    std::array<bool, 8> exists;  ///< whether a block does, by octant, see upper_neighbour
    LayerBits whole;             ///< cells with all their nodes
};

/// The nodes in and around one block, given the inside bits of all.
NodesAround nodes_around(const BlockGrid& grid, std::span<const LayerBits> inside, std::size_t block);

/// The cells of a block that have all their nodes and both signs.
LayerBits cut_cells(const NodesAround& nodes);

/// The cases of all cells of a block, each the set of its inside corners (mesh/cell_cases.h).
class CellCases {
public:
    explicit CellCases(const NodesAround& nodes);

    std::uint8_t operator()(std::size_t bit, std::size_t z) const {
        return cases_[z / 2][bit % kBlockEdge][z % 2][bit / kBlockEdge];
    }

private:
    using Column = std::array<std::uint8_t, kBlockEdge>;                               // along y
    std::array<std::array<std::array<Column, 2>, kBlockEdge>, kBlockEdge / 2> cases_;  // of two layers, place by place
};

/// Inside bits of all blocks, of values below 0.
std::vector<LayerBits> inside_layers(const BlockGrid& grid, std::span<const float> values);

/// The same, where they are known unit by unit; takes no memory of its own from whoever hands his over.
std::vector<LayerBits> inside_layers(std::vector<InsideBits> inside);

/// Cut edges of all blocks. One entry more than blocks: the last one's first_vertex is the total.
std::vector<CutEdges> find_cut_edges(const BlockGrid& grid, std::span<const LayerBits> inside);

}  // namespace meniscus
