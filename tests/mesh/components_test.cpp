// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/components.h"

#include <gtest/gtest.h>

#include <numbers>

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

TEST(Components, NothingInAnEmptyMesh) {
    Mesh mesh;
    EXPECT_TRUE(label_components(mesh).empty());
    EXPECT_TRUE(mesh.components.empty());
}

}  // namespace
}  // namespace meniscus
