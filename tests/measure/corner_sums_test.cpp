// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/corner_sums.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "meniscus/threads.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

// A third of the triangles' areas, summed at the vertices.
std::vector<float> areas_at_vertices(const Mesh& mesh) {
    std::vector<float> thirds;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 normal = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
        thirds.push_back(static_cast<float>(norm(normal) / 6.0));
    }
    return sums_at_corners(mesh.vertices.size(), mesh.triangles, thirds);
}

TEST(CornerSums, OfATetrahedronAreEqual) {
    for (const float area : areas_at_vertices(tetrahedron()))
        EXPECT_FLOAT_EQ(area, static_cast<float>(2.0 * std::sqrt(3.0)));
}

TEST(CornerSums, OfAreasSumToTheAreaOfTheMesh) {
    Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.1);
    mesh.vertices.push_back({0, 0, 0});  // of no triangle
    const std::vector<float> areas = areas_at_vertices(mesh);
    EXPECT_EQ(areas.back(), 0.0F);
    EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0) / area_of(mesh), 1.0, 1e-7);
}

TEST(CornerSums, AreTheSameForAnyNumberOfThreads) {
    Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.1);
    const auto half = static_cast<std::ptrdiff_t>(mesh.triangles.size() / 2);
    std::shuffle(mesh.triangles.begin(), mesh.triangles.begin() + half, std::mt19937(1));  // no more next to neighbours
    const std::vector<float> of_several = areas_at_vertices(mesh);
    const ThreadLimit limit(1);
    EXPECT_EQ(areas_at_vertices(mesh), of_several);
}

TEST(CornerSums, HaveAllTrianglesLookedAtOnce) {
    const Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.1);
    const std::vector<float> ones(mesh.triangles.size(), 1.0F);
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        std::vector<std::atomic<int>> looks(mesh.triangles.size());
        sums_at_corners(mesh.vertices.size(), mesh.triangles, ones, [&](std::span<const Triangle> some) {
            for (const Triangle& triangle : some) ++looks[static_cast<std::size_t>(&triangle - mesh.triangles.data())];
        });
        EXPECT_TRUE(std::all_of(looks.begin(), looks.end(), [](int looked) { return looked == 1; }));
    }
}

TEST(CornerSums, FollowNoTriangleThatTheLookRefuses) {
    Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.1);
    mesh.triangles.back()[1] = 4'000'000'000U;
    const std::vector<float> ones(mesh.triangles.size(), 1.0F);
    const auto refuse = [&](std::span<const Triangle> some) {
        for (const Triangle& triangle : some)
            if (triangle[1] >= mesh.vertices.size()) throw std::out_of_range("a corner");
    };
    for (const int threads : {1, 2}) {
        const ThreadLimit limit(threads);
        EXPECT_THROW(sums_at_corners(mesh.vertices.size(), mesh.triangles, ones, refuse), std::out_of_range);
    }
}

}  // namespace
}  // namespace meniscus::testing
