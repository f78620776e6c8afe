// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/depth_layers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "render/small_scenes.h"

namespace meniscus {
namespace {

constexpr Vec3 kUpwards{0.0, 0.0, 1.0};

/// A square across the axis, as two triangles.
void add_square(Mesh& mesh, double height) {
    const auto first = static_cast<VertexId>(mesh.vertices.size());
    for (const auto& [x, y] : {std::pair{-5.0, -5.0}, {5.0, -5.0}, {5.0, 5.0}, {-5.0, 5.0}})
        mesh.vertices.push_back({x, y, height});
    mesh.triangles.push_back({first, first + 1, first + 2});
    mesh.triangles.push_back({first, first + 2, first + 3});
}

TEST(DepthLayers, TheNearestOfSeveralLayersCounts) {
    Mesh mesh;
    for (const double height : {9.0, 1.0, 4.0, -3.0}) add_square(mesh, height);
    const DepthLayers layers(mesh, kUpwards, 0.5);
    for (const Vec3 point : {Vec3{0.1, 0.2, 2.0}, Vec3{-4.9, 4.9, 2.0}, Vec3{4.6, -0.3, 2.0}}) {
        const DepthLayers::Gaps gaps = layers.gaps(point);
        EXPECT_FLOAT_EQ(gaps.above, 2.0F);
        EXPECT_FLOAT_EQ(gaps.below, 1.0F);
    }
}

TEST(DepthLayers, BesideAndBeyondTheMeshThereIsNothing) {
    Mesh mesh;
    add_square(mesh, 1.0);
    const DepthLayers layers(mesh, kUpwards, 0.5);
    EXPECT_TRUE(std::isinf(layers.gaps({7.0, 0.0, 0.0}).above));
    EXPECT_TRUE(std::isinf(layers.gaps({0.0, -7.0, 0.0}).above));
    EXPECT_TRUE(std::isinf(layers.gaps({0.0, 0.0, 2.0}).above));
    EXPECT_FLOAT_EQ(layers.gaps({0.0, 0.0, 2.0}).below, 1.0F);
}

TEST(DepthLayers, SlantedAxesMeetABallWhereItIs) {
    const Mesh ball = testing::blue_sphere({{3, -2, 7}, 4.0}, 0.2).mesh;
    for (const Vec3 axis : {normalised(Vec3{1, 2, 3}), normalised(Vec3{-3, 1, -1}), Vec3{0, 0, -1}}) {
        const DepthLayers::Gaps gaps = DepthLayers(ball, axis, 0.1).gaps({3, -2, 7});
        EXPECT_NEAR(gaps.above, 4.0, 0.01);
        EXPECT_NEAR(gaps.below, 4.0, 0.01);
    }
}

TEST(DepthLayers, AMeshWithoutExtentHasNoLayers) {
    Mesh speck;
    speck.vertices.assign(3, {1, 1, 1});
    speck.triangles = {{0, 1, 2}};
    EXPECT_TRUE(std::isinf(DepthLayers(speck, kUpwards, 0.5).gaps({1, 1, 0}).above));
}

}  // namespace
}  // namespace meniscus
