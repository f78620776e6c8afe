// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/surface_distance.h"

#include <gtest/gtest.h>

#include <numeric>

#include "meniscus/errors.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

TEST(SurfaceDistance, OfATetrahedronHasTheRightSignAtCornersAndEdges) {
    const Mesh mesh = tetrahedron();
    const SurfaceDistance distance(mesh, nullptr);
    std::vector<Vec3> outside;
    std::vector<Vec3> inside;
    for (const Vec3& corner : mesh.vertices)
        for (const Vec3& other : mesh.vertices) {  // the corners, where they are the same, else edges
            outside.push_back(0.55 * (corner + other));
            inside.push_back(0.45 * (corner + other));
        }
    for (const double d : distance(outside)) EXPECT_GT(d, 0.0);
    for (const double d : distance(inside)) EXPECT_LT(d, 0.0);
    EXPECT_NEAR(distance(std::vector<Vec3>{2.0 * mesh.vertices[0]})[0], std::sqrt(3.0), 1e-12);
}

TEST(SurfaceDistance, SignsNeedNoSharedVertices) {
    const Mesh sphere = projected_sphere({{}, 2.0}, 0.5);
    Mesh soup;
    for (const Triangle& t : sphere.triangles) {
        const auto first = static_cast<VertexId>(soup.vertices.size());
        for (const VertexId v : t) soup.vertices.push_back(sphere.vertices[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    std::vector<Vec3> points;
    for (const Vec3& v : sphere.vertices) {
        points.push_back(1.2 * v);
        points.push_back(0.8 * v);
    }
    const std::vector<double> distances = SurfaceDistance(soup, nullptr)(points);
    for (std::size_t i = 0; i < distances.size(); ++i) EXPECT_EQ(distances[i] > 0.0, i % 2 == 0);
}

TEST(SurfaceDistance, OfAnExactSurfaceIsThatOfTheAtoms) {
    const AccessibleSurface surface({{{}}, {3.0}}, 1.4);
    const SurfaceDistance distance({}, &surface);
    EXPECT_NEAR(distance(std::vector<Vec3>{{0, 0, 3.5}})[0], 0.5, 1e-9);
    std::vector<Vec3> points{{0, 0, 3.5}, {2, 0, 0}};
    move_onto(surface, points);
    for (const Vec3& p : points) EXPECT_NEAR(norm(p), 3.0, 1e-9);
}

TEST(SpreadOverTriangles, StandsForTheWholeAreaAsDenselyAsAsked) {
    const Mesh mesh = tetrahedron();  // area 8 sqrt(3)
    for (const double density : {0.001, 1.0, 20.0}) {
        const WeightedPoints spread = spread_over_triangles(mesh, density);
        EXPECT_NEAR(std::accumulate(spread.areas.begin(), spread.areas.end(), 0.0), area_of(mesh), 1e-9);
        EXPECT_GE(static_cast<double>(spread.points.size()), density * area_of(mesh));
        EXPECT_GE(spread.points.size(), 16U);
    }
    EXPECT_THROW(spread_over_triangles(mesh, 1e15), LimitError);
}

}  // namespace
}  // namespace meniscus::testing
