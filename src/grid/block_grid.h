// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A block-sparse regular grid: cubes of 8³ nodes, kept only where the narrow band needs them.
//
// A field on the grid is a plain array with one entry per node: entry `block * kBlockNodes + node`, where
// node = x + 8 * (y + 8 * z) inside the block. Blocks are ordered by (z, y, x).
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus {

inline constexpr int kBlockEdge = 8;
inline constexpr int kBlockNodes = kBlockEdge * kBlockEdge * kBlockEdge;

/// Number of a block in a BlockGrid.
using BlockId = std::uint32_t;
inline constexpr BlockId kNoBlock = 0xffffffffU;

/// Position of a block, in units of its edge.
struct BlockCoord {
    std::int32_t z = 0;
    std::int32_t y = 0;
    std::int32_t x = 0;
    auto operator<=>(const BlockCoord&) const = default;  // NOLINT(modernize-use-nullptr): clang-tidy 14 is wrong
};

/// Hash of a block's position, for tables of blocks.
struct BlockCoordHash {
    std::size_t operator()(const BlockCoord& c) const {
        std::uint64_t h = (static_cast<std::uint64_t>(static_cast<std::uint32_t>(c.x)) * 0x9E3779B97F4A7C15ULL) ^
                          (static_cast<std::uint64_t>(static_cast<std::uint32_t>(c.y)) * 0xC2B2AE3D27D4EB4FULL) ^
                          (static_cast<std::uint64_t>(static_cast<std::uint32_t>(c.z)) * 0x165667B19E3779F9ULL);
        h ^= h >> 32U;
        return static_cast<std::size_t>(h * 0xD6E8FEB86659FD93ULL >> 16U);
    }
};

/// Number of a node within its block.
constexpr int node_in_block(int x, int y, int z) { return x + kBlockEdge * (y + kBlockEdge * z); }

/// Along one axis: the block that holds a node, counted from that of block 0, and where in the block it is.
constexpr std::int32_t block_of_node(std::int64_t node) {
    constexpr int kShift = 3;
    static_assert(kBlockEdge == 1 << kShift);
    return static_cast<std::int32_t>(node >> kShift);
}
constexpr int place_in_block(std::int64_t node) { return static_cast<int>(node & (kBlockEdge - 1)); }

/// Number of a neighbour in BlockGrid::neighbours; dx, dy, dz in {-1, 0, 1}.
constexpr int neighbour_slot(int dx, int dy, int dz) { return (dx + 1) + 3 * (dy + 1) + 9 * (dz + 1); }

/// Which block along one axis holds a node that is at most a block's edge beside this one: -1, 0 or 1.
constexpr int side_of(int node) { return node < 0 ? -1 : (node >= kBlockEdge ? 1 : 0); }

class BlockGrid {
public:
    /// Blocks may come in any order, without repetition. The node (0, 0, 0) of block (0, 0, 0) is at `origin`.
    BlockGrid(double spacing, const Vec3& origin, std::vector<BlockCoord> blocks);

    double spacing() const { return spacing_; }
    const Vec3& origin() const { return origin_; }
    std::size_t block_count() const { return blocks_.size(); }
    std::size_t node_count() const { return blocks_.size() * kBlockNodes; }
    const BlockCoord& coord(BlockId block) const { return blocks_[block]; }
    std::span<const BlockCoord> coords() const { return blocks_; }

    /// The block at a position, or kNoBlock.
    BlockId find(const BlockCoord& coord) const;

    /// The 27 blocks around and including `block` (see neighbour_slot); kNoBlock where there is none.
    const std::array<BlockId, 27>& neighbours(BlockId block) const { return neighbours_[block]; }

    /// Position of the block's node (0, 0, 0), Å.
    Vec3 corner(BlockId block) const { return corner(blocks_[block]); }
    Vec3 corner(const BlockCoord& coord) const;

    /// Position of an entry of a field, Å.
    Vec3 position(std::size_t entry) const {
        constexpr std::size_t kEdge = kBlockEdge;
        const std::size_t node = entry % kBlockNodes;
        const std::size_t y = node / kEdge % kEdge;
        const std::size_t z = node / (kEdge * kEdge);
        const Vec3 steps{static_cast<double>(node % kEdge), static_cast<double>(y), static_cast<double>(z)};
        return corner(static_cast<BlockId>(entry / kBlockNodes)) + spacing_ * steps;
    }

private:
    void fill_slots();

    double spacing_;
    Vec3 origin_;
    std::vector<BlockCoord> blocks_;
    std::vector<BlockId> slots_;  // open-addressing hash table over blocks_
    std::vector<std::array<BlockId, 27>> neighbours_;
};

/// Edge of a block with one layer of its neighbours' nodes around it.
inline constexpr int kPaddedEdge = kBlockEdge + 2;
inline constexpr int kPaddedNodes = kPaddedEdge * kPaddedEdge * kPaddedEdge;

/// A block and the nodes next to it: padded node (x + 1) + 10 * ((y + 1) + 10 * (z + 1)).
/// Nodes of missing blocks become `fill`.
template <class T>
std::array<T, kPaddedNodes> gather_padded(const BlockGrid& grid, std::span<const T> field, BlockId block, T fill) {
    std::array<T, kPaddedNodes> padded;
    const auto& around = grid.neighbours(block);
    std::size_t to = 0;
    for (int z = -1; z <= kBlockEdge; ++z)
        for (int y = -1; y <= kBlockEdge; ++y, to += kPaddedEdge) {
            const int row = node_in_block(0, y & (kBlockEdge - 1), z & (kBlockEdge - 1));
            const auto value = [&](int dx, int x) {
                const BlockId b = around[static_cast<std::size_t>(neighbour_slot(dx, side_of(y), side_of(z)))];
                return b == kNoBlock ? fill : field[std::size_t{b} * kBlockNodes + static_cast<std::size_t>(row + x)];
            };
            const BlockId middle = around[static_cast<std::size_t>(neighbour_slot(0, side_of(y), side_of(z)))];
            padded[to] = value(-1, kBlockEdge - 1);
            if (middle == kNoBlock)
                std::fill_n(padded.begin() + static_cast<std::ptrdiff_t>(to + 1), kBlockEdge, fill);
            else
                std::copy_n(field.begin() + static_cast<std::ptrdiff_t>(std::size_t{middle} * kBlockNodes) + row,
                            kBlockEdge, padded.begin() + static_cast<std::ptrdiff_t>(to + 1));
            padded[to + kPaddedEdge - 1] = value(1, 0);
        }
    return padded;
}

}  // namespace meniscus
