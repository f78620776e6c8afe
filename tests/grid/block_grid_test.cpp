// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_grid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <random>
#include <set>

#include "support/sampled_field.h"

namespace meniscus::testing {
namespace {

// A random half of a box of blocks around the origin, shuffled.
std::vector<BlockCoord> random_blocks(std::uint64_t seed) {
    std::vector<BlockCoord> blocks = box_of_blocks({.z = -3, .y = -2, .x = -4}, {.z = 2, .y = 3, .x = 1});
    std::shuffle(blocks.begin(), blocks.end(), std::mt19937_64(seed));
    blocks.resize(blocks.size() / 2);
    return blocks;
}

std::vector<float> numbered_nodes(const BlockGrid& grid) {
    std::vector<float> field(grid.node_count());
    std::iota(field.begin(), field.end(), 1.0F);
    return field;
}

// The value at a node given by its position in the whole lattice.
float direct_lookup(const BlockGrid& grid, const std::vector<float>& field, const std::array<int, 3>& node,
                    float fill) {
    const auto block_of = [](int i) { return i >= 0 ? i / kBlockEdge : -((-i + kBlockEdge - 1) / kBlockEdge); };
    const BlockCoord coord{.z = block_of(node[2]), .y = block_of(node[1]), .x = block_of(node[0])};
    const BlockId block = grid.find(coord);
    if (block == kNoBlock) return fill;
    const int local =
        node_in_block(node[0] - kBlockEdge * coord.x, node[1] - kBlockEdge * coord.y, node[2] - kBlockEdge * coord.z);
    return field[std::size_t{block} * kBlockNodes + static_cast<std::size_t>(local)];
}

TEST(BlockGrid, FindsItsBlocksAndNoOthers) {
    const std::vector<BlockCoord> blocks = random_blocks(1);
    const BlockGrid grid(0.5, {}, blocks);
    EXPECT_EQ(grid.block_count(), blocks.size());
    EXPECT_EQ(grid.node_count(), blocks.size() * 512);
    const std::set<BlockCoord> present(blocks.begin(), blocks.end());
    for (const BlockCoord& c : box_of_blocks({.z = -5, .y = -5, .x = -5}, {.z = 5, .y = 5, .x = 5})) {
        const BlockId found = grid.find(c);
        EXPECT_EQ(found != kNoBlock, present.contains(c));
        if (found != kNoBlock) {
            EXPECT_EQ(grid.coord(found), c);
        }
    }
}

TEST(BlockGrid, OrdersBlocksWhateverTheirOrderWas) {
    const std::vector<BlockCoord> blocks = random_blocks(2);
    const BlockGrid grid(0.5, {}, blocks);
    EXPECT_TRUE(std::is_sorted(grid.coords().begin(), grid.coords().end()));
    std::vector<BlockCoord> reversed(blocks.rbegin(), blocks.rend());
    const BlockGrid other(0.5, {}, reversed);
    EXPECT_TRUE(std::equal(grid.coords().begin(), grid.coords().end(), other.coords().begin()));
}

TEST(BlockGrid, KnowsItsNeighbours) {
    const BlockGrid grid(0.5, {}, random_blocks(3));
    for (BlockId b = 0; b < grid.block_count(); ++b) {
        const BlockCoord& c = grid.coord(b);
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    EXPECT_EQ(grid.neighbours(b)[static_cast<std::size_t>(neighbour_slot(dx, dy, dz))],
                              grid.find({.z = c.z + dz, .y = c.y + dy, .x = c.x + dx}));
        EXPECT_EQ(grid.neighbours(b)[static_cast<std::size_t>(neighbour_slot(0, 0, 0))], b);
    }
}

TEST(BlockGrid, PlacesCornersAtMultiplesOfTheEdge) {
    const BlockGrid grid(0.25, {0.1, -0.2, 1000.0}, {{.z = -3, .y = 0, .x = 7}});
    EXPECT_EQ(grid.corner(0), (Vec3{0.1 + 14.0, -0.2, 1000.0 - 6.0}));
    EXPECT_EQ(grid.corner({.z = 0, .y = 0, .x = 0}), grid.origin());
}

TEST(BlockGrid, HoldsNothing) {
    const BlockGrid grid(0.5, {}, {});
    EXPECT_EQ(grid.block_count(), 0U);
    EXPECT_EQ(grid.find({.z = 0, .y = 0, .x = 0}), kNoBlock);
}

TEST(BlockGrid, HoldsBlocksFarApart) {
    constexpr std::int32_t kFar = (1 << 30) - 1;
    const BlockGrid grid(0.5, {}, {{.z = kFar, .y = -kFar, .x = kFar}, {.z = 0, .y = 0, .x = 0}});
    EXPECT_EQ(grid.find({.z = kFar, .y = -kFar, .x = kFar}), 1U);
    EXPECT_EQ(grid.find({.z = 0, .y = 0, .x = 0}), 0U);
    EXPECT_EQ(grid.find({.z = kFar, .y = kFar, .x = kFar}), kNoBlock);
}

TEST(GatherPadded, EqualsDirectLookups) {
    const BlockGrid grid(0.5, {}, random_blocks(4));
    const std::vector<float> field = numbered_nodes(grid);
    constexpr float kFill = -7.0F;
    for (BlockId b = 0; b < grid.block_count(); ++b) {
        const auto padded = gather_padded<float>(grid, field, b, kFill);
        const BlockCoord& c = grid.coord(b);
        std::size_t at = 0;
        for (int z = -1; z <= kBlockEdge; ++z)
            for (int y = -1; y <= kBlockEdge; ++y)
                for (int x = -1; x <= kBlockEdge; ++x, ++at)
                    ASSERT_EQ(padded[at],
                              direct_lookup(grid, field,
                                            {kBlockEdge * c.x + x, kBlockEdge * c.y + y, kBlockEdge * c.z + z}, kFill));
    }
}

TEST(GatherPadded, ALonelyBlockIsSurroundedByTheFill) {
    const BlockGrid grid(0.5, {}, {{.z = 0, .y = 0, .x = 0}});
    const std::vector<float> field(kBlockNodes, 1.0F);
    const auto padded = gather_padded<float>(grid, field, 0, 5.0F);
    EXPECT_EQ(std::count(padded.begin(), padded.end(), 1.0F), kBlockNodes);
    EXPECT_EQ(std::count(padded.begin(), padded.end(), 5.0F), kPaddedNodes - kBlockNodes);
}

}  // namespace
}  // namespace meniscus::testing
