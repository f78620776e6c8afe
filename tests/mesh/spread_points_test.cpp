// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/spread_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/parallel.h"
#include "meniscus/threads.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

constexpr double kRadius = 5.0;

Mesh ball() { return projected_sphere({{0.1, 0.2, 0.3}, kRadius}, 0.5); }

std::vector<double> nearest_distances(const std::vector<Vec3>& points) {
    std::vector<double> result;
    for (std::size_t i = 0; i < points.size(); ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t j = 0; j < points.size(); ++j)
            if (j != i) least = std::min(least, norm(points[i] - points[j]));
        result.push_back(least);
    }
    return result;
}

// What neighbours would be apart if all were packed in triangles.
double packed_distance(std::size_t count) {
    const double area = 4.0 * std::numbers::pi * kRadius * kRadius;
    return std::sqrt(2.0 * area / (std::numbers::sqrt3 * static_cast<double>(count)));
}

TEST(SpreadPoints, AreAsManyAsAskedFor) {
    const Mesh mesh = ball();
    for (const std::size_t count : {0U, 1U, 2U, 7U, 300U}) {
        const PointsOnMesh spread = spread_points(mesh, count, 0);
        EXPECT_EQ(spread.points.size(), count);
        EXPECT_EQ(spread.triangles.size(), count);
    }
}

TEST(SpreadPoints, LieInTheirTriangles) {
    const Mesh mesh = ball();
    const PointsOnMesh spread = spread_points(mesh, 400, 3);
    for (std::size_t i = 0; i < spread.points.size(); ++i) {
        const auto [a, b, c] = mesh.triangles[spread.triangles[i]];
        const auto area = [](const Vec3& p, const Vec3& q, const Vec3& r) { return norm(cross(q - p, r - p)); };
        const Vec3& p = spread.points[i];
        const Vec3& u = mesh.vertices[a];
        const Vec3& v = mesh.vertices[b];
        const Vec3& w = mesh.vertices[c];
        EXPECT_NEAR(area(p, u, v) + area(p, v, w) + area(p, w, u), area(u, v, w), 1e-12);
    }
}

TEST(SpreadPoints, KeepTheirDistance) {
    const std::vector<double> distances = nearest_distances(spread_points(ball(), 500, 1).points);
    EXPECT_GT(*std::min_element(distances.begin(), distances.end()), 0.65 * packed_distance(500));
    double mean = 0.0;
    for (const double d : distances) mean += d / 500.0;
    EXPECT_GT(mean, 0.75 * packed_distance(500));
}

TEST(SpreadPoints, ScatteredPointsDoNot) {
    const std::vector<double> distances = nearest_distances(scatter_points(ball(), 500, 1).points);
    EXPECT_LT(*std::min_element(distances.begin(), distances.end()), 0.2 * packed_distance(500));
}

TEST(SpreadPoints, CoverEqualAreasAlike) {
    const PointsOnMesh spread = spread_points(ball(), 2000, 5);
    std::size_t above = 0;
    for (const Vec3& p : spread.points) above += p.z > 0.3 ? 1 : 0;
    EXPECT_NEAR(static_cast<double>(above), 1000.0, 30.0);
}

TEST(SpreadPoints, AreTheSameForASeedAndAnyNumberOfThreads) {
    const Mesh mesh = ball();
    const PointsOnMesh many = spread_points(mesh, 800, 9);
    const ThreadLimit one(1);
    EXPECT_TRUE(spread_points(mesh, 800, 9).points == many.points);
    EXPECT_FALSE(spread_points(mesh, 800, 10).points == many.points);
}

// Two faces 0.1 Å apart: each keeps as many points as if it were alone.
TEST(SpreadPoints, DoNotSeeTheOtherSideOfAThinWall) {
    Mesh wall;
    for (const double z : {0.0, 0.1})
        for (const double y : {0.0, 20.0})
            for (const double x : {0.0, 20.0}) wall.vertices.push_back({x, y, z});
    wall.triangles = {{0, 3, 1}, {0, 2, 3}, {4, 5, 7}, {4, 7, 6}};
    const PointsOnMesh spread = spread_points(wall, 400, 2);
    std::vector<Vec3> lower;
    std::copy_if(spread.points.begin(), spread.points.end(), std::back_inserter(lower),
                 [](const Vec3& p) { return p.z < 0.05; });
    EXPECT_NEAR(static_cast<double>(lower.size()), 200.0, 5.0);
    const std::vector<double> all = nearest_distances(spread.points);
    EXPECT_LT(*std::min_element(all.begin(), all.end()), 0.5);  // seen through the wall
    const std::vector<double> own = nearest_distances(lower);
    EXPECT_GT(*std::min_element(own.begin(), own.end()), 0.65 * std::sqrt(2.0 * 400.0 / (std::numbers::sqrt3 * 200.0)));
}

}  // namespace
}  // namespace meniscus::testing
