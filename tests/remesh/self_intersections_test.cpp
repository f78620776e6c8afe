// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/self_intersections.h"

#include <gtest/gtest.h>

#include "support/shapes.h"

namespace meniscus::testing {
namespace {

TEST(SelfIntersections, AreNoneOnASphere) {
    EXPECT_TRUE(places_of_self_intersections(projected_sphere({{}, 2.0}, 0.4)).empty());
    EXPECT_TRUE(places_of_self_intersections(tetrahedron()).empty());
    EXPECT_TRUE(places_of_self_intersections({}).empty());
}

TEST(SelfIntersections, OfTwoSpheresLieOnTheirCircle) {
    Mesh mesh = projected_sphere({{}, 2.0}, 0.4);
    append(mesh, projected_sphere({{2.0, 0.1, 0.2}, 2.0}, 0.4));
    const auto places = places_of_self_intersections(mesh);
    EXPECT_GT(places.size(), 20u);
    for (const Vec3& place : places) {
        EXPECT_NEAR(norm(place), 2.0, 0.05);
        EXPECT_NEAR(norm(place - Vec3{2.0, 0.1, 0.2}), 2.0, 0.05);
    }
}

TEST(SelfIntersections, AVertexPushedThroughTheOtherSideIsFound) {
    Mesh mesh = projected_sphere({{}, 2.0}, 0.4);
    mesh.vertices[10] = -1.3 * mesh.vertices[10];
    EXPECT_FALSE(places_of_self_intersections(mesh).empty());
}

TEST(SelfIntersections, NeighboursThatShareAVertexAreLookedAtBeyondIt) {
    // Two fans from one corner: the second's far side passes through the first.
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {2, -1, 0}, {2, 1, 0}, {1, 0, -1}, {1, 0.2, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 4}};
    EXPECT_EQ(places_of_self_intersections(mesh).size(), 1u);
    mesh.vertices[4] = {1, 0.2, -0.1};
    EXPECT_TRUE(places_of_self_intersections(mesh).empty());
}

}  // namespace
}  // namespace meniscus::testing
