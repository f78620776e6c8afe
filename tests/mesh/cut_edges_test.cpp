// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/cut_edges.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "mesh/cell_cases.h"
#include "support/sampled_field.h"

namespace meniscus {
namespace {

using testing::SampledField;

SampledField random_signs(std::vector<BlockCoord> blocks, unsigned seed) {
    std::mt19937 random(seed);
    return testing::sample(BlockGrid(1.0, {}, std::move(blocks)),
                           [&](const Vec3&) { return random() % 2 == 0 ? -1.0 : 1.0; });
}

// The value of a node counted from a block's corner, coordinates 0..8; nullptr where there is no block.
const float* value_at(const SampledField& field, BlockId block, std::size_t x, std::size_t y, std::size_t z) {
    const std::size_t octant = x / kBlockEdge + 2 * (y / kBlockEdge) + 4 * (z / kBlockEdge);
    const BlockId b = upper_neighbour(field.grid.neighbours(block), octant);
    if (b == kNoBlock) return nullptr;
    const auto node = static_cast<std::size_t>(node_in_block(x % kBlockEdge, y % kBlockEdge, z % kBlockEdge));
    return &field.values[std::size_t{b} * kBlockNodes + node];
}

TEST(CutEdges, InsideMeansBelowZero) {
    SampledField field = testing::sample(BlockGrid(1.0, {}, {BlockCoord{}}), [](const Vec3&) { return 1.0; });
    field.values[0] = -1.0F;
    field.values[1] = 0.0F;
    field.values[2] = -0.0F;
    field.values[3] = -std::numeric_limits<float>::denorm_min();
    field.values[kBlockNodes - 1] = -1.0F;
    field.values[static_cast<std::size_t>(node_in_block(5, 2, 1))] = -1.0F;
    const LayerBits bits = inside_layers(field.grid, field.values).front();
    EXPECT_EQ(bits, (LayerBits{0b1001U, std::uint64_t{1} << (5 + 8 * 2), 0, 0, 0, 0, 0, std::uint64_t{1} << 63U}));
}

TEST(CutEdges, LayersHoldTheBitsOfUnits) {
    std::mt19937_64 random(3);
    std::vector<InsideBits> inside(2);
    for (InsideBits& units : inside)
        for (UnitBits& unit : units) unit = random();
    const std::vector<LayerBits> layers = inside_layers(inside);
    for (std::size_t b = 0; b < inside.size(); ++b)
        for (int z = 0; z < kBlockEdge; ++z)
            for (int y = 0; y < kBlockEdge; ++y)
                for (int x = 0; x < kBlockEdge; ++x)
                    EXPECT_EQ((layers[b][static_cast<std::size_t>(z)] >> (x + kBlockEdge * y) & 1U) != 0,
                              inside_bit(inside[b], x, y, z));
}

TEST(CutEdges, FindsEveryEdgeWithTwoSignsAndNoOther) {
    // Two diagonal neighbours exist, the others do not.
    const SampledField field = random_signs({{}, {.z = 0, .y = 0, .x = 1}, {.z = 1, .y = 1, .x = 0}}, 5);
    const std::vector<CutEdges> edges = find_cut_edges(field.grid, inside_layers(field.grid, field.values));
    std::size_t count = 0;
    for (BlockId b = 0; b < field.grid.block_count(); ++b) {
        EXPECT_EQ(edges[b].first_vertex, count);
        for (std::size_t d = 0; d < 3; ++d)
            for (std::size_t z = 0; z < kBlockEdge; ++z) {
                EXPECT_EQ(edges[b].first_vertex + edges[b].rank[d][z], count);
                for (std::size_t y = 0; y < kBlockEdge; ++y)
                    for (std::size_t x = 0; x < kBlockEdge; ++x) {
                        const float* near = value_at(field, b, x, y, z);
                        const float* far =
                            value_at(field, b, x + (d == 0 ? 1 : 0), y + (d == 1 ? 1 : 0), z + (d == 2 ? 1 : 0));
                        const bool cut = far != nullptr && (*near < 0.0F) != (*far < 0.0F);
                        const std::size_t bit = x + kBlockEdge * y;
                        EXPECT_EQ((edges[b].bits[d][z] >> bit & 1U) != 0, cut);
                        EXPECT_EQ(edges[b].vertex(d, bit, z), count);
                        count += cut ? 1 : 0;
                    }
            }
    }
    EXPECT_EQ(edges.back().first_vertex, count);
}

TEST(CutEdges, FindsTheCasesOfExactlyTheCellsWithAllNodesAndBothSigns) {
    std::vector<BlockCoord> blocks;
    std::mt19937 random(9);
    for (const BlockCoord& c : testing::box_of_blocks({}, {.z = 2, .y = 2, .x = 2}))
        if (random() % 4 != 0) blocks.push_back(c);
    const SampledField field = random_signs(blocks, 13);
    const std::vector<LayerBits> inside = inside_layers(field.grid, field.values);
    for (BlockId b = 0; b < field.grid.block_count(); ++b) {
        const NodesAround nodes = nodes_around(field.grid, inside, b);
        const LayerBits cut = cut_cells(nodes);
        const CellCases cases(nodes);
        for (std::size_t z = 0; z < kBlockEdge; ++z)
            for (std::size_t y = 0; y < kBlockEdge; ++y)
                for (std::size_t x = 0; x < kBlockEdge; ++x) {
                    int expected = 0;
                    for (unsigned k = 0; k < kCellCorners && expected >= 0; ++k) {
                        const float* value = value_at(field, b, x + (k & 1U), y + (k >> 1U & 1U), z + (k >> 2U));
                        expected = value == nullptr ? -1 : expected | (*value < 0.0F ? 1 << k : 0);
                    }
                    const bool is_cut = expected > 0 && expected < 255;
                    const std::size_t bit = x + kBlockEdge * y;
                    EXPECT_EQ((cut[z] >> bit & 1U) != 0, is_cut);
                    EXPECT_TRUE(!is_cut || cases(bit, z) == expected);
                }
    }
}

}  // namespace
}  // namespace meniscus
