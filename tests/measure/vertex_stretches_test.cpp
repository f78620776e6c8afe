// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/vertex_stretches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "support/shapes.h"

namespace meniscus::testing {
namespace {

// How often the vertices of every stretch are met among the triangles that it visits.
std::vector<std::size_t> corners_met(std::size_t vertex_count, std::span<const Triangle> triangles) {
    std::vector<std::size_t> met(vertex_count);
    const VertexStretches stretches(vertex_count, triangles);
    for (std::size_t s = 0; s < stretches.size(); ++s)
        stretches.visit_triangles(s, [&](const Triangle& triangle, std::size_t number) {
            EXPECT_EQ(triangle, triangles[number]);
            for (const VertexId v : triangle)
                if (v >= stretches.first(s) && v - stretches.first(s) < stretches.count(s)) ++met[v];
        });
    return met;
}

std::vector<std::size_t> corners_of(std::size_t vertex_count, std::span<const Triangle> triangles) {
    std::vector<std::size_t> corners(vertex_count);
    for (const Triangle& triangle : triangles)
        for (const VertexId v : triangle) ++corners[v];
    return corners;
}

TEST(VertexStretches, OfNothingAreNone) { EXPECT_EQ(VertexStretches(0, {}).size(), 0U); }

TEST(VertexStretches, HoldEveryVertexOnce) {
    for (const std::size_t n : {1U, 4095U, 4096U, 4097U, 10000U}) {
        const VertexStretches stretches(n, {});
        std::size_t next = 0;
        for (std::size_t s = 0; s < stretches.size(); ++s) {
            EXPECT_EQ(stretches.first(s), next);
            next += stretches.count(s);
        }
        EXPECT_EQ(next, n);
    }
}

TEST(VertexStretches, MeetEveryCornerOnceOnASphere) {
    const Mesh mesh = extracted_sphere({.centre = {0.1, 0.2, 0.3}, .radius = 4.0}, 0.08);
    ASSERT_GT(mesh.vertices.size(), 20000U);
    EXPECT_EQ(corners_met(mesh.vertices.size(), mesh.triangles), corners_of(mesh.vertices.size(), mesh.triangles));
}

TEST(VertexStretches, MeetEveryCornerOnceInAnyOrder) {
    constexpr std::size_t kVertices = 9000;
    std::mt19937 random(1);
    std::uniform_int_distribution<VertexId> any(0, kVertices - 1);
    std::vector<Triangle> triangles(100000);
    std::generate(triangles.begin(), triangles.end(), [&] { return Triangle{any(random), any(random), any(random)}; });
    EXPECT_EQ(corners_met(kVertices, triangles), corners_of(kVertices, triangles));
}

}  // namespace
}  // namespace meniscus::testing
