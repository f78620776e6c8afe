// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/mesh_part.h"

#include <gtest/gtest.h>

#include <stdexcept>

#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

/// Two tetrahedra, eight vertices that belong to atoms 0 to 7.
Mesh two_pieces() {
    Mesh mesh = testing::tetrahedron();
    for (std::size_t v = 0; v < 4; ++v) mesh.vertices.push_back(mesh.vertices[v] + Vec3{10, 0, 0});
    for (std::size_t t = 0; t < 4; ++t) {
        const auto [a, b, c] = mesh.triangles[t];
        mesh.triangles.push_back({a + 4, b + 4, c + 4});
    }
    mesh.atoms = {0, 1, 2, 3, 4, 5, 6, 7};
    mesh.components = {0, 0, 0, 0, 1, 1, 1, 1};
    mesh.values = {{"phi", {0, 1, 2, 3, 4, 5, 6, 7}}};
    return mesh;
}

TEST(MeshPart, TrianglesBelongToTheMajorityOfTheirCorners) {
    const Mesh mesh = two_pieces();
    std::vector<bool> selected(8, false);
    selected[0] = selected[1] = true;
    const MeshPart part = part_of_atoms(mesh, selected);
    EXPECT_EQ(part.mesh.triangles.size(), 2U);  // those along the edge 0 - 1
    EXPECT_EQ(part.vertices.size(), 4U);
    selected.flip();
    EXPECT_EQ(part_of_atoms(mesh, selected).mesh.triangles.size(), 6U);
}

TEST(MeshPart, KeepsWhatIsKnownOfVertices) {
    const Mesh mesh = two_pieces();
    const MeshPart part = part_of_component(mesh, 1);
    EXPECT_EQ(part.vertices, (std::vector<VertexId>{4, 5, 6, 7}));
    EXPECT_EQ(part.mesh.atoms, (std::vector<std::uint32_t>{4, 5, 6, 7}));
    EXPECT_EQ(part.mesh.values[0].values, (std::vector<float>{4, 5, 6, 7}));
    EXPECT_EQ(part.mesh.triangles, testing::tetrahedron().triangles);
    EXPECT_EQ(part.mesh.vertices[0], mesh.vertices[4]);
    EXPECT_TRUE(part.mesh.normals.empty());
    testing::expect_closed_manifold(part.mesh);
}

TEST(MeshPart, NothingSelectedIsNothing) {
    const MeshPart part = part_of_atoms(two_pieces(), std::vector<bool>(8, false));
    EXPECT_TRUE(part.mesh.triangles.empty());
    EXPECT_TRUE(part.mesh.vertices.empty());
}

TEST(MeshPart, ArraysThatAreNeededMustBeThere) {
    EXPECT_THROW(part_of_atoms(testing::tetrahedron(), {}), std::invalid_argument);
    EXPECT_THROW(part_of_component(testing::tetrahedron(), 0), std::invalid_argument);
}

}  // namespace
}  // namespace meniscus
