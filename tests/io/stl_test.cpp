// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/stl.h"

#include <gtest/gtest.h>

#include "support/mesh_readers.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::Facets;
using testing::ScratchFolder;

std::string written_stl(const Mesh& mesh, Encoding encoding) {
    const ScratchFolder folder;
    write_mesh(folder / "a.stl", mesh, {.encoding = encoding});
    return testing::read_file(folder / "a.stl");
}

void expect_facets_of(const Facets& facets, const Mesh& mesh) {
    ASSERT_EQ(facets.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < facets.size(); ++t) {
        const auto& [normal, a, b, c] = facets[t];
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = mesh.vertices[mesh.triangles[t][i]];
            EXPECT_EQ(static_cast<float>(facets[t][i + 1].x), static_cast<float>(p.x));
            EXPECT_EQ(static_cast<float>(facets[t][i + 1].y), static_cast<float>(p.y));
            EXPECT_EQ(static_cast<float>(facets[t][i + 1].z), static_cast<float>(p.z));
        }
        EXPECT_NEAR(norm(normal), 1.0, 1e-6);
        EXPECT_GT(dot(normal, normalised(cross(b - a, c - a))), 0.999);
    }
}

TEST(Stl, BinaryReadsBack) {
    const Mesh mesh = testing::projected_sphere({.centre = {1, 2, 3}, .radius = 1.5}, 0.3);
    const std::string content = written_stl(mesh, Encoding::Binary);
    EXPECT_TRUE(content.starts_with("meniscus"));  // "solid" would make readers take it for text
    expect_facets_of(testing::read_binary_stl(content), mesh);
}

TEST(Stl, TextReadsBack) {
    const Mesh mesh = testing::projected_sphere({.centre = {1, 2, 3}, .radius = 1.5}, 0.3);
    expect_facets_of(testing::read_text_stl(written_stl(mesh, Encoding::Text)), mesh);
}

TEST(Stl, TextHasAllDigitsFarFromTheOrigin) {
    Mesh mesh = testing::tetrahedron();
    for (Vec3& v : mesh.vertices) v.x = 123456.78901 + 1e-3 * v.x;
    EXPECT_EQ(testing::read_text_stl(written_stl(mesh, Encoding::Text))[0][1], mesh.vertices[0]);
}

TEST(Stl, FacetsWithoutAreaHaveNoNormal) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[1] = mesh.vertices[0];
    EXPECT_EQ(testing::read_binary_stl(written_stl(mesh, Encoding::Binary))[0][0], Vec3{});
}

TEST(Stl, AnEmptyMeshIsAValidFile) {
    EXPECT_TRUE(testing::read_binary_stl(written_stl({}, Encoding::Binary)).empty());
    EXPECT_EQ(written_stl({}, Encoding::Text), "solid meniscus\nendsolid meniscus\n");
}

}  // namespace
}  // namespace meniscus
