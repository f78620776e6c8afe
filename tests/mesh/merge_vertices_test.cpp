// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/merge_vertices.h"

#include <gtest/gtest.h>

#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

TEST(MergeVertices, ASoupOfTrianglesBecomesClosedAgain) {
    const Mesh sphere = extracted_sphere({{1, 2, 3}, 1.5}, 0.4);
    Mesh soup;
    for (const Triangle& t : sphere.triangles) {
        const auto first = static_cast<VertexId>(soup.vertices.size());
        for (const VertexId v : t) soup.vertices.push_back(sphere.vertices[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const std::size_t corners = soup.vertices.size();
    EXPECT_EQ(merge_vertices(soup), corners - sphere.vertices.size());
    expect_closed_manifold(soup);
    EXPECT_EQ(area_of(soup), area_of(sphere));
}

TEST(MergeVertices, BothZerosAreOneAndUnusedVerticesGo) {
    Mesh mesh;
    mesh.vertices = {{9, 9, 9}, {0.0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-0.0, 0, 0}, {0, 0, 1}};
    mesh.triangles = {{1, 2, 3}, {4, 3, 5}};
    EXPECT_EQ(merge_vertices(mesh), 2U);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}}));
    EXPECT_EQ(mesh.vertices.size(), 4U);
}

TEST(MergeVertices, OfNothingIsNothing) {
    Mesh mesh;
    EXPECT_EQ(merge_vertices(mesh), 0U);
}

}  // namespace
}  // namespace meniscus::testing
