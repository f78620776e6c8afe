// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/mesh_quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "measure/mesh_distance.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

TEST(MeshQuality, OfATetrahedronIsThatOfEquilateralTriangles) {
    const MeshQuality quality = measure_quality(tetrahedron());
    EXPECT_EQ(quality.angles[5] + quality.angles[6], 12u);
    EXPECT_NEAR(quality.smallest_angles.min, 60.0, 1e-9);
    EXPECT_NEAR(quality.aspect_ratios.max, 1.0, 1e-12);
    EXPECT_NEAR(quality.edges.min, std::sqrt(8.0), 1e-12);
    EXPECT_NEAR(quality.edges.max, std::sqrt(8.0), 1e-12);
}

TEST(MeshQuality, KnowsARightTriangle) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {3, 0, 0}, {0, 4, 0}};
    mesh.triangles = {{0, 1, 2}};
    const MeshQuality quality = measure_quality(mesh);
    EXPECT_NEAR(quality.smallest_angles.p50, std::atan2(3.0, 4.0) * 180.0 / std::numbers::pi, 1e-9);
    EXPECT_NEAR(quality.aspect_ratios.p50, 2.5 / (2.0 * 1.0), 1e-12);  // R = 5/2, r = 1
    EXPECT_EQ(quality.angles[9], 1u);
    EXPECT_EQ(std::accumulate(quality.angles.begin(), quality.angles.end(), std::size_t{0}), 3u);
}

TEST(MeshQuality, PercentilesAreThoseOfSortedValues) {
    // Isosceles triangles with angles of 0, 0.5, 1 ... 50 degrees at their tips, in no order.
    constexpr VertexId kCount = 101;
    Mesh mesh;
    for (VertexId i = 0; i < kCount; ++i) {
        const double half = 0.25 * (i * 37 % kCount) * std::numbers::pi / 180.0;
        mesh.vertices.insert(mesh.vertices.end(),
                             {{0, 0, 0}, {std::cos(half), std::sin(half), 0}, {std::cos(half), -std::sin(half), 0}});
        mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
    }
    const Percentiles angles = measure_quality(mesh).smallest_angles;
    EXPECT_NEAR(angles.min, 0.0, 1e-5);
    EXPECT_NEAR(angles.p5, 2.5, 1e-9);
    EXPECT_NEAR(angles.p50, 25.0, 1e-9);
    EXPECT_NEAR(angles.p95, 47.5, 1e-9);
    EXPECT_NEAR(angles.max, 50.0, 1e-9);
}

// Lengths and aspect ratios of all triangles of a mesh, sorted.
std::array<std::vector<double>, 2> sorted_shapes(const Mesh& mesh) {
    std::vector<double> edges;
    std::vector<double> ratios;
    for (const Triangle& triangle : mesh.triangles) {
        const auto side = [&](std::size_t k) {
            return norm(mesh.vertices[triangle[(k + 2) % 3]] - mesh.vertices[triangle[(k + 1) % 3]]);
        };
        const double a = side(0);
        const double b = side(1);
        const double c = side(2);
        edges.insert(edges.end(), {a, b, c});
        ratios.push_back(a * b * c / ((b + c - a) * (c + a - b) * (a + b - c)));
    }
    std::sort(edges.begin(), edges.end());
    std::sort(ratios.begin(), ratios.end());
    return {edges, ratios};
}
void expect_percentiles(const Percentiles& found, const std::vector<double>& sorted) {
    const auto at = [&](double part) {
        return sorted[static_cast<std::size_t>(std::lround(part * static_cast<double>(sorted.size() - 1)))];
    };
    EXPECT_EQ(found.min, sorted.front());
    EXPECT_EQ(found.p5, at(0.05));
    EXPECT_EQ(found.p50, at(0.5));
    EXPECT_EQ(found.p95, at(0.95));
    EXPECT_EQ(found.max, sorted.back());
}

TEST(MeshQuality, PercentilesOfALargeMeshAreThoseOfSortedValues) {
    Mesh mesh = extracted_sphere({.centre = {0.1, 0.2, 0.3}, .radius = 4.0}, 0.05);
    ASSERT_GT(mesh.triangles.size(), 100000U);  // so many that a sample tells where to look
    const auto [edges, ratios] = sorted_shapes(mesh);
    const MeshQuality quality = measure_quality(mesh);
    expect_percentiles(quality.edges, edges);
    expect_percentiles(quality.aspect_ratios, ratios);
    EXPECT_EQ(std::accumulate(quality.angles.begin(), quality.angles.end(), std::size_t{0}), edges.size());
}

// Triangles that stand where samples are taken may be like no others.
TEST(MeshQuality, PercentilesDoNotDependOnTheSample) {
    for (const VertexId period : {1U, 2U, 4U, 16U, 32U, 64U, 128U}) {
        Mesh mesh;
        std::mt19937 random(1);
        std::uniform_real_distribution<double> length(1.0, 2.0);
        for (VertexId t = 0; t < 70000; ++t) {
            const double width = length(random) * (t % period == 0 ? 0.01 : 1.0);
            mesh.vertices.insert(mesh.vertices.end(), {{0, 0, 0}, {width, 0, 0}, {0, length(random), 0}});
            mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
        }
        const auto [edges, ratios] = sorted_shapes(mesh);
        const MeshQuality quality = measure_quality(mesh);
        expect_percentiles(quality.edges, edges);
        expect_percentiles(quality.aspect_ratios, ratios);
    }
}

TEST(MeshQuality, CornersAreCountedByTheirAngles) {
    // A fan around the origin, with tips of 0.05, 0.15 ... 179.95 degrees.
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}};
    std::array<std::size_t, 18> expected{};
    for (VertexId i = 0; i < 1800; ++i) {
        const double tip = 0.1 * i + 0.05;
        const double angle = tip * std::numbers::pi / 180.0;
        mesh.vertices.push_back({std::cos(angle), std::sin(angle), 0});
        mesh.triangles.push_back({0, 1, i + 2});
        ++expected[static_cast<std::size_t>(tip / 10.0)];
        expected[static_cast<std::size_t>((90.0 - 0.5 * tip) / 10.0)] += 2;  // isosceles
    }
    EXPECT_EQ(measure_quality(mesh).angles, expected);
}

TEST(MeshQuality, DegenerateTrianglesHaveNoAngle) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {0, 0, 0}, {1, 0, 0}};
    mesh.triangles = {{0, 1, 2}};
    const MeshQuality quality = measure_quality(mesh);
    EXPECT_EQ(quality.smallest_angles.max, 0.0);
    EXPECT_EQ(quality.angles[0], 3u);
}

TEST(MeshQuality, OfNothingIsNothing) {
    EXPECT_EQ(measure_quality({}).edges.max, 0.0);
    const ExactSurface surface({{{}}, {1.7}});
    EXPECT_EQ(measure_distance({}, surface).to_exact.max, 0.0);
    EXPECT_EQ(mean_distance_to_exact({}, surface.accessible(), 1), 0.0);
}

TEST(MeshDistance, OfASphereIsThatOfItsChords) {
    const ExactSurface surface({{{}}, {3.0}});
    double last = 0.0;
    for (const double spacing : {0.8, 0.4}) {
        const TwoSidedDistance distance = measure_distance(projected_sphere({{}, 3.0}, spacing), surface);
        EXPECT_NEAR(distance.to_exact.mean, distance.from_exact.mean, 0.02 * distance.to_exact.mean);
        EXPECT_GE(distance.to_exact.max, distance.to_exact.p99);
        EXPECT_GT(distance.to_exact.p99, distance.to_exact.mean);
        if (last > 0.0) {
            EXPECT_NEAR(last / distance.to_exact.mean, 4.0, 0.8);
        }
        last = distance.to_exact.mean;
    }
}

TEST(MeshDistance, MeanIsToldBySomeTriangles) {
    const ExactSurface surface({{{}}, {3.0}});
    const Mesh mesh = projected_sphere({{}, 3.0}, 0.2);
    const double mean = measure_distance(mesh, surface).to_exact.mean;
    EXPECT_NEAR(mean_distance_to_exact(mesh, surface.accessible(), 1), mean, 1e-12 * mean);
    EXPECT_NEAR(mean_distance_to_exact(mesh, surface.accessible(), 3), mean, 0.05 * mean);
    EXPECT_NE(mean_distance_to_exact(mesh, surface.accessible(), 3), mean);
}

TEST(MeshDistance, OfAShiftedSphereIsTheShift) {
    const ExactSurface surface({{{}}, {3.0}});
    const TwoSidedDistance distance = measure_distance(projected_sphere({{}, 3.2}, 0.2), surface);
    EXPECT_NEAR(distance.to_exact.mean, 0.2, 0.01);
    EXPECT_NEAR(distance.from_exact.mean, 0.2, 0.01);
}

}  // namespace
}  // namespace meniscus::testing
