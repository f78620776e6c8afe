// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/components.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>
#include <random>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/parallel.h"
#include "meniscus/threads.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::append;
using testing::extracted_sphere;
using testing::turned_inside_out;

TEST(Components, OnePieceIsNumberZero) {
    Mesh mesh = testing::tetrahedron();
    const std::vector<MeshComponent> pieces = label_components(mesh);
    ASSERT_EQ(pieces.size(), 1U);
    EXPECT_EQ(mesh.components, std::vector<std::uint32_t>(4, 0));
    EXPECT_EQ(pieces[0].vertices, 4U);
    EXPECT_EQ(pieces[0].triangles, 4U);
    EXPECT_NEAR(pieces[0].volume, 8.0 / 3.0, 1e-14);
    EXPECT_NEAR(pieces[0].area, 8.0 * std::sqrt(3.0), 1e-14);
}

TEST(Components, VerticesOfPiecesAreCountedWhereTheyStandInTurns) {
    std::vector<std::uint32_t> of_vertex(40000, 3);
    std::fill_n(of_vertex.begin(), 5, 1);
    for (std::size_t v = 100; v < of_vertex.size(); v += 2) of_vertex[v] = 0;
    const PieceVertices pieces = vertices_of_pieces(of_vertex);
    EXPECT_EQ(pieces.counts, (std::vector<std::size_t>{19950, 5, 0, 20045}));
    EXPECT_EQ(pieces.first, (std::vector<VertexId>{100, 0, 0, 5}));
}

TEST(Components, FallingVolumeWithCavitiesInTheSameRow) {
    Mesh mesh;
    append(mesh, extracted_sphere({.centre = {9, 0, 0}, .radius = 1.0}, 0.25));                     // third
    append(mesh, turned_inside_out(extracted_sphere({.centre = {1, 0, 0}, .radius = 1.5}, 0.25)));  // second
    append(mesh, extracted_sphere({.centre = {0, 0, 0}, .radius = 4.0}, 0.25));                     // first
    const Components found = find_components(mesh);
    ASSERT_EQ(found.pieces.size(), 3U);
    EXPECT_EQ(found.of_vertex.front(), 2U);
    EXPECT_EQ(found.of_vertex.back(), 0U);
    EXPECT_GT(found.pieces[0].volume, 250.0);
    EXPECT_LT(found.pieces[1].volume, -12.0);
    EXPECT_GT(found.pieces[2].volume, 3.0);
}

TEST(Components, LargestOuterPieceComesFirstEvenBesideALargerHole) {
    Mesh mesh = turned_inside_out(extracted_sphere({.centre = {}, .radius = 3.0}, 0.25));
    append(mesh, extracted_sphere({.centre = {9, 0, 0}, .radius = 1.0}, 0.25));
    append(mesh, extracted_sphere({.centre = {-9, 0, 0}, .radius = 1.5}, 0.25));
    const std::vector<MeshComponent> pieces = label_components(mesh);
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_NEAR(pieces[0].volume, 4.0 / 3.0 * std::numbers::pi * 1.5 * 1.5 * 1.5, 0.4);
    EXPECT_LT(pieces[1].volume, 0.0);
    EXPECT_EQ(mesh.components.front(), 1U);
}

TEST(Components, AreRenumberedTogetherWithWhatTheyMeasure) {
    std::vector<MeshComponent> pieces{
        {.vertices = 1, .volume = -9.0}, {.vertices = 2, .volume = 3.0}, {.vertices = 3, .volume = 5.0}};
    std::vector<std::uint32_t> of_vertex{0, 1, 1, 2, 2, 2};
    renumber(pieces, of_vertex);
    EXPECT_EQ(of_vertex, (std::vector<std::uint32_t>{1, 2, 2, 0, 0, 0}));
    ASSERT_EQ(pieces.size(), 3U);
    EXPECT_EQ(pieces[0].vertices, 3U);
    EXPECT_EQ(pieces[1].vertices, 1U);
    EXPECT_EQ(pieces[2].vertices, 2U);
}

TEST(Components, VolumeKeepsItsDigitsFarFromTheOrigin) {
    Mesh mesh = testing::tetrahedron();
    for (Vec3& v : mesh.vertices) v += Vec3{1 << 20, -(1 << 20), 1 << 20};
    EXPECT_NEAR(label_components(mesh)[0].volume, 8.0 / 3.0, 1e-14);
}

TEST(Components, OnlyThoseToKeepAreKept) {
    Mesh mesh;
    append(mesh, extracted_sphere({.centre = {9, 0, 0}, .radius = 1.0}, 0.25));                     // third
    append(mesh, turned_inside_out(extracted_sphere({.centre = {1, 0, 0}, .radius = 1.5}, 0.25)));  // second
    append(mesh, extracted_sphere({.centre = {0, 0, 0}, .radius = 4.0}, 0.25));                     // first
    const std::vector<MeshComponent> before = label_components(mesh);
    keep_components(mesh, {true, false, true});
    testing::expect_closed_manifold(mesh);
    const std::vector<MeshComponent> after = measure_components(mesh, mesh.components);
    ASSERT_EQ(after.size(), 2U);
    EXPECT_DOUBLE_EQ(after[0].volume, before[0].volume);
    EXPECT_DOUBLE_EQ(after[1].area, before[2].area);
    keep_components(mesh, {false, false});
    EXPECT_TRUE(mesh.vertices.empty() && mesh.triangles.empty() && mesh.components.empty());
}

TEST(Components, EqualVolumesKeepTheOrderOfTheirVertices) {
    Mesh mesh = testing::tetrahedron();
    append(mesh, testing::tetrahedron());
    label_components(mesh);
    EXPECT_EQ(mesh.components, (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 1, 1, 1}));
}

// Many small pieces whose triangles are in no order, so that every task joins parts of all of them.
Mesh scattered_triangles(std::size_t vertices, std::size_t triangles) {
    std::mt19937 random(11);
    Mesh mesh;
    mesh.vertices.resize(vertices);
    std::uniform_real_distribution<double> within(0.0, 1.0);
    for (Vec3& v : mesh.vertices) v = {within(random), within(random), within(random)};
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto corner = [&] { return static_cast<VertexId>(random() % vertices); };
        mesh.triangles.push_back({corner(), corner(), corner()});
    }
    return mesh;
}

// How many different pairs of numbers two labellings make: as many as pieces if they tell the same apart.
std::size_t count_pairs(const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
    for (std::size_t i = 0; i < a.size(); ++i) pairs.emplace_back(a[i], b[i]);
    std::sort(pairs.begin(), pairs.end());
    return static_cast<std::size_t>(std::unique(pairs.begin(), pairs.end()) - pairs.begin());
}

TEST(Components, AreThoseOfPlainUnionFindForAnyNumberOfThreads) {
    for (const std::size_t triangles : {20000U, 60000U}) {
        const Mesh mesh = scattered_triangles(100000, triangles);
        DisjointSets plain(mesh.vertices.size());
        for (const auto& [a, b, c] : mesh.triangles) {
            plain.join(a, b);
            plain.join(b, c);
        }
        const std::vector<std::uint32_t> expected = plain.numbers();
        const auto with_threads = [&](int threads) {
            const ThreadLimit limit(threads);
            return find_components(mesh).of_vertex;
        };
        const std::vector<std::uint32_t> found = with_threads(4);
        EXPECT_EQ(found, with_threads(1));
        EXPECT_EQ(set_count(found), set_count(expected));
        EXPECT_EQ(count_pairs(found, expected), set_count(expected));
    }
}

TEST(Components, NothingInAnEmptyMesh) {
    Mesh mesh;
    EXPECT_TRUE(label_components(mesh).empty());
    EXPECT_TRUE(mesh.components.empty());
}

}  // namespace
}  // namespace meniscus
