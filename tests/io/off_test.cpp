// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/off.h"

#include <gtest/gtest.h>

#include "meniscus/write.h"
#include "support/mesh_readers.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;

Mesh written_off(const Mesh& mesh) {
    const ScratchFolder folder;
    write_mesh(folder / "a.off", mesh);
    return testing::read_off(testing::read_file(folder / "a.off"));
}

TEST(Off, TrianglesAndPositionsReadBack) {
    const Mesh mesh = testing::projected_sphere({.centre = {1, 2, 3}, .radius = 1.5}, 0.3);
    const Mesh read = written_off(mesh);
    EXPECT_EQ(read.triangles, mesh.triangles);
    ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_EQ(static_cast<float>(read.vertices[v].y), static_cast<float>(mesh.vertices[v].y));
}

TEST(Off, AllDigitsFarFromTheOrigin) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[0].x = 123456.78901;
    EXPECT_EQ(written_off(mesh).vertices, mesh.vertices);
}

TEST(Off, AnEmptyMeshIsAValidFile) { EXPECT_TRUE(written_off({}).triangles.empty()); }

}  // namespace
}  // namespace meniscus
