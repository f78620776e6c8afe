// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/obj.h"

#include <gtest/gtest.h>

#include "meniscus/write.h"
#include "support/mesh_readers.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;

Mesh written_obj(const Mesh& mesh) {
    const ScratchFolder folder;
    write_mesh(folder / "a.obj", mesh);
    return testing::read_obj(testing::read_file(folder / "a.obj"));
}

TEST(Obj, TrianglesAndPositionsReadBack) {
    const Mesh mesh = testing::projected_sphere({.centre = {1, 2, 3}, .radius = 1.5}, 0.3);
    const Mesh read = written_obj(mesh);
    EXPECT_EQ(read.triangles, mesh.triangles);
    ASSERT_EQ(read.vertices.size(), mesh.vertices.size());
    ASSERT_EQ(read.normals.size(), mesh.normals.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        EXPECT_EQ(static_cast<float>(read.vertices[v].x), static_cast<float>(mesh.vertices[v].x));
        EXPECT_EQ(static_cast<float>(read.vertices[v].z), static_cast<float>(mesh.vertices[v].z));
        EXPECT_EQ(static_cast<float>(read.normals[v].y), static_cast<float>(mesh.normals[v].y));
    }
}

TEST(Obj, WithoutNormals) {
    const ScratchFolder folder;
    write_mesh(folder / "a.obj", testing::tetrahedron());
    const std::string text = testing::read_file(folder / "a.obj");
    EXPECT_NE(text.find("\nv -1 -1 1\n"), std::string::npos);
    EXPECT_NE(text.find("\nf 1 3 2\n"), std::string::npos);
    EXPECT_EQ(text.find("vn"), std::string::npos);
}

TEST(Obj, AllDigitsFarFromTheOrigin) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[0].x = 123456.78901;
    EXPECT_EQ(written_obj(mesh).vertices, mesh.vertices);
}

}  // namespace
}  // namespace meniscus
