// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/topology.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

MeshTopology examine(const Mesh& mesh) { return examine_topology(mesh.vertices.size(), mesh.triangles); }

// Two rings of n vertices with a pole each: the poles have n triangles.
Mesh spindle(VertexId n) {
    Mesh mesh;
    mesh.vertices.resize(n + std::size_t{2});
    for (VertexId i = 0; i < n; ++i) {
        const VertexId j = (i + 1) % n;
        mesh.triangles.push_back({i, j, n});
        mesh.triangles.push_back({j, i, n + 1});
    }
    return mesh;
}

TEST(Topology, NothingIsClosedAndManifold) {
    const MeshTopology topology = examine_topology(0, {});
    EXPECT_TRUE(topology.closed);
    EXPECT_TRUE(topology.manifold);
    EXPECT_EQ(topology.edges, 0U);
}

TEST(Topology, ClosedSurfacesOfAnyVertexDegree) {
    for (const VertexId n : {3U, 5U, 15U, 16U, 17U, 1000U, 100000U}) {
        const MeshTopology topology = examine(spindle(n));
        EXPECT_TRUE(topology.closed);
        EXPECT_TRUE(topology.manifold);
        EXPECT_EQ(topology.edges, 3U * n);
    }
}

TEST(Topology, ExtractedSphere) {
    const Mesh mesh = testing::extracted_sphere({.centre = {0.1, 0.2, 0.3}, .radius = 2.0}, 0.25);
    const MeshTopology topology = examine(mesh);
    EXPECT_TRUE(topology.closed);
    EXPECT_TRUE(topology.manifold);
    EXPECT_EQ(topology.edges, mesh.triangles.size() * 3 / 2);
}

TEST(Topology, AHoleIsNotClosedButManifold) {
    Mesh mesh = testing::tetrahedron();
    mesh.triangles.pop_back();
    const MeshTopology topology = examine(mesh);
    EXPECT_FALSE(topology.closed);
    EXPECT_TRUE(topology.manifold);
    EXPECT_EQ(topology.edges, 6U);
}

TEST(Topology, ATurnedTriangleIsNotClosedButManifold) {
    Mesh mesh = testing::tetrahedron();
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    const MeshTopology topology = examine(mesh);
    EXPECT_FALSE(topology.closed);
    EXPECT_TRUE(topology.manifold);
    EXPECT_EQ(topology.edges, 6U);
}

TEST(Topology, TwoPiecesThatShareAVertexAreClosedButNotManifold) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices.resize(7);
    for (Triangle t : testing::tetrahedron().triangles) {
        for (VertexId& v : t) v = v == 0 ? 0 : v + 3;
        mesh.triangles.push_back(t);
    }
    const MeshTopology topology = examine(mesh);
    EXPECT_TRUE(topology.closed);
    EXPECT_FALSE(topology.manifold);
}

TEST(Topology, AnEdgeWithFourTrianglesIsNeither) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices.resize(6);
    for (Triangle t : testing::tetrahedron().triangles) {
        for (VertexId& v : t) v = v < 2 ? v : v + 2;
        mesh.triangles.push_back(t);
    }
    const MeshTopology topology = examine(mesh);
    EXPECT_FALSE(topology.closed);
    EXPECT_FALSE(topology.manifold);
    EXPECT_EQ(topology.edges, 11U);
}

TEST(Topology, RepeatedCornersAreNeither) {
    Mesh mesh = testing::tetrahedron();
    mesh.triangles.push_back({1, 1, 2});
    EXPECT_FALSE(examine(mesh).closed);
    EXPECT_FALSE(examine(mesh).manifold);
    mesh.triangles.back() = {3, 3, 3};
    EXPECT_FALSE(examine(mesh).closed);
    EXPECT_FALSE(examine(mesh).manifold);
}

TEST(Topology, ALoneVertexIsNotManifold) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices.emplace_back();
    EXPECT_TRUE(examine(mesh).closed);
    EXPECT_FALSE(examine(mesh).manifold);
}

TEST(Topology, OneTurnedTriangleIsFoundAnywhereInALargeMesh) {
    const Mesh whole = testing::extracted_sphere({.centre = {0.1, 0.2, 0.3}, .radius = 4.0}, 0.08);
    ASSERT_GT(whole.vertices.size(), 20000U);
    for (const std::size_t t : {std::size_t{0}, whole.triangles.size() / 2, whole.triangles.size() - 1}) {
        Mesh mesh = whole;
        std::swap(mesh.triangles[t][0], mesh.triangles[t][1]);
        const MeshTopology topology = examine(mesh);
        EXPECT_FALSE(topology.closed);
        EXPECT_TRUE(topology.manifold);
        EXPECT_EQ(topology.edges, mesh.triangles.size() * 3 / 2);
    }
}

TEST(Topology, AgreesWithThePlainCheckerOnDamagedMeshes) {
    const Mesh whole = testing::extracted_sphere({.centre = {0.1, 0.2, 0.3}, .radius = 1.0}, 0.5);
    std::mt19937 random(5);
    for (int round = 0; round < 300; ++round) {
        Mesh mesh = whole;
        Triangle& t = mesh.triangles[random() % mesh.triangles.size()];
        switch (random() % 4) {
            case 0:
                std::swap(t[0], t[1]);
                break;
            case 1:
                t[random() % 3] = static_cast<VertexId>(random() % mesh.vertices.size());
                break;
            case 2:
                t = mesh.triangles.back();
                break;
            default:
                std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
                break;
        }
        const MeshTopology topology = examine(mesh);
        EXPECT_EQ(topology.closed && topology.manifold, testing::why_not_closed_manifold(mesh).empty());
        EXPECT_EQ(static_cast<std::int64_t>(mesh.vertices.size() + mesh.triangles.size() - topology.edges),
                  testing::euler_characteristic_of(mesh));
    }
}

bool is_balanced(std::span<const Triangle> triangles) { return signed_areas(triangles) == 0; }

TEST(Balance, HoldsForClosedSurfacesAlone) {
    EXPECT_TRUE(is_balanced({}));
    EXPECT_TRUE(is_balanced(testing::tetrahedron().triangles));
    EXPECT_TRUE(is_balanced(spindle(1000).triangles));
    Mesh mesh = testing::extracted_sphere({.centre = {0.1, 0.2, 0.3}, .radius = 2.0}, 0.25);
    EXPECT_TRUE(is_balanced(mesh.triangles));
    std::reverse(mesh.triangles.begin(), mesh.triangles.end());
    for (Triangle& t : mesh.triangles) t = {t[1], t[2], t[0]};
    EXPECT_TRUE(is_balanced(mesh.triangles));
    std::mt19937 random(5);
    for (int i = 0; i < 300; ++i) {
        const auto t = static_cast<std::ptrdiff_t>(random() % mesh.triangles.size());
        Mesh turned = mesh;
        std::swap(turned.triangles[static_cast<std::size_t>(t)][0], turned.triangles[static_cast<std::size_t>(t)][1]);
        EXPECT_FALSE(is_balanced(turned.triangles));
        Mesh twice = mesh;
        twice.triangles.push_back(mesh.triangles[static_cast<std::size_t>(t)]);
        EXPECT_FALSE(is_balanced(twice.triangles));
        mesh.triangles.erase(mesh.triangles.begin() + t);  // more holes every time
        EXPECT_FALSE(is_balanced(mesh.triangles));
    }
}

TEST(Balance, TellsTheTopologyOfManifolds) {
    Mesh mesh = testing::extracted_sphere({.centre = {0.1, 0.2, 0.3}, .radius = 2.0}, 0.25);
    const auto expect_same = [&] {
        const MeshTopology known =
            topology_of_manifold(mesh.vertices.size(), mesh.triangles, signed_areas(mesh.triangles));
        const MeshTopology examined = examine(mesh);
        EXPECT_EQ(known.closed, examined.closed);
        EXPECT_EQ(known.manifold, examined.manifold);
        EXPECT_EQ(known.edges, examined.edges);
    };
    expect_same();
    mesh.triangles.pop_back();
    expect_same();
}

}  // namespace
}  // namespace meniscus
