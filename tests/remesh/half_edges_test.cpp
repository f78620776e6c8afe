// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/half_edges.h"

#include <gtest/gtest.h>

#include <random>
#include <stdexcept>

#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

Mesh mesh_of(const HalfEdges& edges) {
    const std::vector<VertexId> vertices = edges.vertices();
    Mesh mesh;
    mesh.triangles = edges.triangles(vertices);
    mesh.vertices.resize(vertices.size());
    return mesh;
}

HalfEdges small_sphere() {
    const Mesh mesh = extracted_sphere({{0.1, 0.2, 0.3}, 1.0}, 0.6);
    return {mesh.vertices.size(), mesh.triangles};
}

std::ptrdiff_t euler_characteristic(const Mesh& mesh) {
    return static_cast<std::ptrdiff_t>(mesh.vertices.size()) - static_cast<std::ptrdiff_t>(mesh.triangles.size()) / 2;
}

TEST(HalfEdges, LeadRoundTrianglesAndVertices) {
    const HalfEdges edges = small_sphere();
    for (HalfEdge h = 0; h < edges.half_edge_slots(); ++h) {
        EXPECT_EQ(next(next(next(h))), h);
        EXPECT_EQ(previous(next(h)), h);
        EXPECT_EQ(edges.twin(edges.twin(h)), h);
        EXPECT_EQ(edges.origin(edges.twin(h)), edges.target(h));
        EXPECT_TRUE(edges.are_neighbours(edges.origin(h), edges.target(h)));
        EXPECT_EQ(edges.between(edges.origin(h), edges.target(h)), h);
    }
    std::size_t sum = 0;
    for (VertexId v = 0; v < edges.vertex_slots(); ++v) {
        edges.for_each_leaving(v, [&](HalfEdge h) { EXPECT_EQ(edges.origin(h), v); });
        sum += edges.valence(v);
    }
    EXPECT_EQ(sum, edges.half_edge_slots());
    EXPECT_EQ(edges.between(0, 0), kNoHalfEdge);
}

TEST(HalfEdges, RefuseMeshesThatAreNotClosed) {
    Mesh mesh = tetrahedron();
    mesh.triangles.pop_back();
    EXPECT_THROW(HalfEdges(4, mesh.triangles), std::invalid_argument);
    mesh = tetrahedron();
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    EXPECT_THROW(HalfEdges(4, mesh.triangles), std::invalid_argument);
}

TEST(HalfEdges, NothingCanBeTakenFromATetrahedron) {
    const Mesh mesh = tetrahedron();
    const HalfEdges edges(4, mesh.triangles);
    for (HalfEdge h = 0; h < 12; ++h) {
        EXPECT_FALSE(edges.can_collapse(h));
        EXPECT_FALSE(edges.can_flip(h));
    }
}

TEST(HalfEdges, SplitAddsAVertexAndTwoTriangles) {
    HalfEdges edges = small_sphere();
    const Mesh before = mesh_of(edges);
    const VertexId a = edges.origin(5);
    const VertexId b = edges.target(5);
    const VertexId middle = edges.split(5);
    EXPECT_EQ(edges.valence(middle), 4u);
    EXPECT_EQ(edges.origin(5), a);
    EXPECT_EQ(edges.target(5), middle);
    EXPECT_TRUE(edges.are_neighbours(middle, b));
    EXPECT_FALSE(edges.are_neighbours(a, b));
    const Mesh after = mesh_of(edges);
    expect_closed_manifold(after);
    EXPECT_EQ(after.vertices.size(), before.vertices.size() + 1);
    EXPECT_EQ(after.triangles.size(), before.triangles.size() + 2);
}

TEST(HalfEdges, CollapseTakesBackASplit) {
    HalfEdges edges = small_sphere();
    const Mesh before = mesh_of(edges);
    const VertexId middle = edges.split(7);
    edges.collapse(edges.leaving(middle));
    const Mesh after = mesh_of(edges);
    expect_closed_manifold(after);
    EXPECT_FALSE(edges.has_vertex(middle));
    EXPECT_EQ(after.vertices.size(), before.vertices.size());
    EXPECT_EQ(after.triangles.size(), before.triangles.size());
}

TEST(HalfEdges, FlipTurnsAnEdge) {
    HalfEdges edges = small_sphere();
    HalfEdge h = 0;
    while (!edges.can_flip(h)) ++h;
    const VertexId a = edges.origin(h);
    const VertexId b = edges.target(h);
    const VertexId c = edges.opposite(h);
    const VertexId d = edges.opposite(edges.twin(h));
    edges.flip(h);
    EXPECT_FALSE(edges.are_neighbours(a, b));
    EXPECT_TRUE(edges.are_neighbours(c, d));
    expect_closed_manifold(mesh_of(edges));
}

TEST(HalfEdges, StayAManifoldOfTheSameTopologyUnderRandomChanges) {
    std::mt19937 random(7);
    HalfEdges edges = small_sphere();
    for (int i = 0; i < 2000; ++i) {
        const HalfEdge h =
            std::uniform_int_distribution<HalfEdge>(0, static_cast<HalfEdge>(edges.half_edge_slots()) - 1)(random);
        if (!edges.has(h)) continue;
        switch (random() % 3) {
            case 0:
                if (edges.can_flip(h)) edges.flip(h);
                break;
            case 1:
                if (edges.can_collapse(h)) edges.collapse(h);
                break;
            default:
                edges.split(h);
        }
        if (i % 100 != 0) continue;
        const Mesh mesh = mesh_of(edges);
        ASSERT_EQ(why_not_closed_manifold(mesh), "") << i;
        ASSERT_EQ(euler_characteristic(mesh), 2) << i;
    }
}

}  // namespace
}  // namespace meniscus::testing
