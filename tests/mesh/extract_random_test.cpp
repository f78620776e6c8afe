// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Marching cubes on random signs: every ambiguity there is, many times over.
#include <gtest/gtest.h>

#include <random>

#include "mesh/extract.h"
#include "support/mesh_checks.h"
#include "support/sampled_field.h"

namespace meniscus {
namespace {

using testing::SampledField;

// Random values at the nodes of some blocks, outside on the rest and on the outermost layer of the box.
SampledField random_field(unsigned seed, double inside_share, float smallest) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0F, 1.0F);
    const double edge = 8.0 * 3.0 - 1.0;
    return testing::sample(
        BlockGrid(1.0, {}, testing::box_of_blocks({}, {.z = 2, .y = 2, .x = 2})), [&](const Vec3& p) {
            const bool margin = p.x < 1 || p.y < 1 || p.z < 1 || p.x > edge - 1 || p.y > edge - 1 || p.z > edge - 1;
            const float size = smallest + (1.0F - smallest) * unit(random);
            return unit(random) < inside_share && !margin ? -size : size;
        });
}

TEST(ExtractRandom, AnySignsGiveAClosedManifold) {
    for (unsigned seed = 0; seed < 24; ++seed) {
        const SampledField field = random_field(seed, 0.1 + 0.8 * (seed % 9) / 8.0, 0.0F);
        const Mesh mesh = extract_zero_set(field.grid, field.values);
        testing::expect_closed_manifold(mesh);
        EXPECT_GT(testing::volume_of(mesh), 0.0);
    }
}

TEST(ExtractRandom, NoTriangleDegeneratesWhateverTheValues) {
    // Powers of ten from 1 to 1e-30 put vertices anywhere between the two ends of an edge, mostly at an end.
    std::mt19937 random(7);
    std::uniform_real_distribution<float> exponent(-30.0F, 0.0F);
    for (unsigned seed = 0; seed < 24; ++seed) {
        SampledField field = random_field(seed, 0.5, 0.5F);
        for (float& v : field.values) v = std::copysign(std::pow(10.0F, exponent(random)), v);
        const Mesh mesh = extract_zero_set(field.grid, field.values);
        testing::expect_closed_manifold(mesh);
        EXPECT_GT(testing::smallest_area_of(mesh), 1e-4);
    }
}

TEST(ExtractRandom, ZeroNodesGiveAClosedManifoldWithoutDegenerateTriangles) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        SampledField field = random_field(seed, 0.5, 1.0F);
        for (float& v : field.values) v = v > 0.0F ? 0.0F : v;
        const Mesh mesh = extract_zero_set(field.grid, field.values);
        testing::expect_closed_manifold(mesh);
        EXPECT_GT(testing::smallest_area_of(mesh), 1e-4);
    }
}

TEST(ExtractRandom, ScatteredBlocksGiveAManifoldWithBoundary) {
    // Half of the blocks are missing: edges have one or two triangles, never more, and every vertex is in use.
    std::mt19937 random(11);
    for (int round = 0; round < 8; ++round) {
        std::vector<BlockCoord> blocks;
        for (const BlockCoord& c : testing::box_of_blocks({}, {.z = 3, .y = 3, .x = 3}))
            if (random() % 2 == 0) blocks.push_back(c);
        const SampledField field =
            testing::sample(BlockGrid(1.0, {}, blocks), [&](const Vec3&) { return random() % 2 == 0 ? -1.0F : 1.0F; });
        const Mesh mesh = extract_zero_set(field.grid, field.values);
        std::map<std::pair<VertexId, VertexId>, int> directed;
        std::vector<bool> used(mesh.vertices.size(), false);
        for (const Triangle& t : mesh.triangles)
            for (std::size_t i = 0; i < 3; ++i) {
                used[t[i]] = true;
                EXPECT_EQ(++directed[std::pair(t[i], t[(i + 1) % 3])], 1);
            }
        EXPECT_EQ(std::count(used.begin(), used.end(), false), 0);
    }
}

}  // namespace
}  // namespace meniscus
