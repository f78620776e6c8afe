// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "space/triangle_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace meniscus::testing {
namespace {

Mesh random_triangles(int count) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> within(-5.0, 5.0);
    const auto point = [&] { return Vec3{within(random), within(random), within(random)}; };
    Mesh mesh;
    for (int i = 0; i < count; ++i) {
        const auto first = static_cast<VertexId>(mesh.vertices.size());
        const Vec3 corner = point();
        mesh.vertices.insert(mesh.vertices.end(), {corner, corner + 0.2 * point(), corner + 0.2 * point()});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

// By points spread over all triangles: too far by up to their spacing, never too near.
double sampled_distance(const Mesh& mesh, const Vec3& point, int steps) {
    double least = std::numeric_limits<double>::infinity();
    for (const auto& [a, b, c] : mesh.triangles)
        for (int i = 0; i <= steps; ++i)
            for (int j = 0; i + j <= steps; ++j) {
                const double u = static_cast<double>(i) / steps;
                const double v = static_cast<double>(j) / steps;
                const Vec3 p = (1.0 - u - v) * mesh.vertices[a] + u * mesh.vertices[b] + v * mesh.vertices[c];
                least = std::min(least, norm(point - p));
            }
    return least;
}

TEST(TriangleTree, DistanceIsThatOfTheNearestTriangle) {
    const Mesh mesh = random_triangles(60);
    const TriangleTree tree(mesh);
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> within(-8.0, 8.0);
    for (int i = 0; i < 50; ++i) {
        const Vec3 point{within(random), within(random), within(random)};
        const double sampled = sampled_distance(mesh, point, 40);
        const double distance = tree.distance(mesh, point);
        EXPECT_LE(distance, sampled + 1e-12);
        EXPECT_GT(distance, sampled - 0.1);
        for (const std::uint32_t near : {0U, 17U, 59U}) EXPECT_EQ(tree.distance(mesh, point, near), distance);
    }
}

TEST(TriangleTree, DistanceToFacesSidesAndCorners) {
    const Mesh mesh{.vertices = {{0, 0, 0}, {2, 0, 0}, {0, 2, 0}},
                    .normals = {},
                    .atoms = {},
                    .patches = {},
                    .components = {},
                    .triangles = {{0, 1, 2}}};
    const TriangleTree tree(mesh);
    EXPECT_DOUBLE_EQ(tree.distance(mesh, {0.5, 0.5, -3}), 3.0);
    EXPECT_DOUBLE_EQ(tree.distance(mesh, {1, -1, 0}), 1.0);
    EXPECT_DOUBLE_EQ(tree.distance(mesh, {2, 2, 0}), std::sqrt(2.0));
    EXPECT_DOUBLE_EQ(tree.distance(mesh, {5, 0, 4}), 5.0);
    EXPECT_DOUBLE_EQ(tree.distance(mesh, {0, 2, 0}), 0.0);
    EXPECT_TRUE(std::isinf(TriangleTree({}).distance({}, {})));
}

TEST(TriangleTree, NearestPointsKnowTheirSide) {
    Mesh mesh;  // a tetrahedron
    mesh.vertices = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
    mesh.triangles = {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}};
    const TriangleTree tree(mesh);
    for (const Vec3& corner : mesh.vertices) {
        const NearestOnMesh outside = tree.nearest(mesh, 1.5 * corner);
        EXPECT_EQ(outside.point, corner);
        EXPECT_NEAR(outside.signed_distance, 0.5 * norm(corner), 1e-12);
        EXPECT_LT(tree.nearest(mesh, 0.9 * corner).signed_distance, 0.0);
    }
    EXPECT_NEAR(tree.nearest(mesh, {}).signed_distance, -1.0 / std::sqrt(3.0), 1e-12);
}

TEST(TriangleTree, NearestPointsDoNotDependOnWhereTheSearchBegins) {
    Mesh mesh = random_triangles(60);
    const auto last = static_cast<VertexId>(mesh.vertices.size() - 1);
    mesh.triangles.push_back({last, last, last});  // without an area: nothing is said of how near it is
    const TriangleTree tree(mesh);
    std::mt19937_64 random(5);
    std::uniform_real_distribution<double> within(-8.0, 8.0);
    for (int i = 0; i < 200; ++i) {
        const Vec3 point{within(random), within(random), within(random)};
        const NearestOnMesh nearest = tree.nearest(mesh, point);
        EXPECT_EQ(std::abs(nearest.signed_distance), tree.distance(mesh, point));
        for (const std::uint32_t near : {17U, 59U, 60U, nearest.triangle}) {
            const NearestOnMesh again = tree.nearest(mesh, point, near);
            EXPECT_EQ(again.signed_distance, nearest.signed_distance);
            EXPECT_EQ(again.point, nearest.point);
            EXPECT_EQ(again.triangle, nearest.triangle);
        }
    }
}

}  // namespace
}  // namespace meniscus::testing
