// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/ply.h"

#include <gtest/gtest.h>

#include <limits>

#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "support/mesh_readers.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::PlyContent;
using testing::ScratchFolder;

PlyContent written_ply(const Mesh& mesh, const WriteOptions& options) {
    const ScratchFolder folder;
    write_mesh(folder / "a.ply", mesh, options);
    return testing::read_ply(testing::read_file(folder / "a.ply"));
}

Mesh full_mesh() {
    Mesh mesh = testing::projected_sphere({.centre = {1, 2, 3}, .radius = 1.5}, 0.3);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        mesh.atoms.push_back(v * 7 + 3000000000U);
        mesh.patches.push_back(static_cast<PatchKind>(v % 3));
        mesh.components.push_back(v % 2);
        mesh.areas.push_back(0.01F * static_cast<float>(v));
        mesh.mean_curvatures.push_back(1.0F / 3.0F - static_cast<float>(v));
        mesh.gaussian_curvatures.push_back(1e-7F * static_cast<float>(v));
        mesh.shape_indices.push_back(v % 2 == 0 ? -1.0F : 0.25F);
    }
    return mesh;
}

class Ply : public ::testing::TestWithParam<Encoding> {};

TEST_P(Ply, EverythingReadsBack) {
    const Mesh mesh = full_mesh();
    std::vector<std::uint32_t> residues(mesh.vertices.size(), std::numeric_limits<std::uint32_t>::max());
    std::vector<float> depths(mesh.vertices.size(), -1.25F);
    const PlyContent ply =
        written_ply(mesh, {.encoding = GetParam(),
                           .extra = {{.name = "residue", .values = std::span<const std::uint32_t>(residues)},
                                     {.name = "depth", .values = std::span<const float>(depths)}}});
    const std::vector<std::pair<std::string, std::string>> expected{{"float", "x"},
                                                                    {"float", "y"},
                                                                    {"float", "z"},
                                                                    {"float", "nx"},
                                                                    {"float", "ny"},
                                                                    {"float", "nz"},
                                                                    {"uint", "atom"},
                                                                    {"uchar", "patch"},
                                                                    {"int", "component"},
                                                                    {"float", "area"},
                                                                    {"float", "mean_curvature"},
                                                                    {"float", "gaussian_curvature"},
                                                                    {"float", "shape_index"},
                                                                    {"uint", "residue"},
                                                                    {"float", "depth"}};
    EXPECT_EQ(ply.properties, expected);
    EXPECT_EQ(ply.triangles, mesh.triangles);
    EXPECT_TRUE(ply.read_to_the_end);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        EXPECT_EQ(ply.values.at("x")[v], static_cast<float>(mesh.vertices[v].x));
        EXPECT_EQ(ply.values.at("z")[v], static_cast<float>(mesh.vertices[v].z));
        EXPECT_EQ(ply.values.at("ny")[v], static_cast<float>(mesh.normals[v].y));
        EXPECT_EQ(ply.values.at("atom")[v], mesh.atoms[v]);
        EXPECT_EQ(ply.values.at("patch")[v], static_cast<double>(mesh.patches[v]));
        EXPECT_EQ(ply.values.at("component")[v], mesh.components[v]);
        EXPECT_EQ(ply.values.at("area")[v], mesh.areas[v]);
        EXPECT_EQ(ply.values.at("mean_curvature")[v], mesh.mean_curvatures[v]);
        EXPECT_EQ(ply.values.at("gaussian_curvature")[v], mesh.gaussian_curvatures[v]);
        EXPECT_EQ(ply.values.at("shape_index")[v], mesh.shape_indices[v]);
        EXPECT_EQ(ply.values.at("residue")[v], 4294967295.0);
        EXPECT_EQ(ply.values.at("depth")[v], -1.25);
    }
}

TEST_P(Ply, ColoursAreTheLastBytesOfAVertex) {
    const std::vector<Colour> colours{{1, 2, 3, 255}, {4, 5, 6, 7}, {255, 0, 128, 255}, {0, 0, 0, 0}};
    const PlyContent ply = written_ply(testing::tetrahedron(), {.encoding = GetParam(), .colours = colours});
    ASSERT_EQ(ply.properties.size(), 7U);
    EXPECT_EQ(ply.properties[3], (std::pair<std::string, std::string>{"uchar", "red"}));
    EXPECT_EQ(ply.values.at("red"), (std::vector<double>{1, 4, 255, 0}));
    EXPECT_EQ(ply.values.at("green"), (std::vector<double>{2, 5, 0, 0}));
    EXPECT_EQ(ply.values.at("blue"), (std::vector<double>{3, 6, 128, 0}));
    EXPECT_EQ(ply.values.at("alpha"), (std::vector<double>{255, 7, 255, 0}));
    EXPECT_TRUE(ply.read_to_the_end);
    EXPECT_THROW(written_ply(testing::tetrahedron(), {.colours = std::span(colours).first(3)}), UsageError);
}

TEST_P(Ply, OnlyWhatTheMeshHasIsWritten) {
    const PlyContent ply = written_ply(testing::tetrahedron(), {.encoding = GetParam()});
    EXPECT_EQ(ply.properties.size(), 3U);
    EXPECT_EQ(ply.values.at("y"), (std::vector<double>{1, -1, 1, -1}));
    EXPECT_TRUE(ply.read_to_the_end);
}

TEST_P(Ply, FarFromTheOriginCoordinatesAreDoubles) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[1].y = -1024.1;
    const PlyContent ply = written_ply(mesh, {.encoding = GetParam()});
    EXPECT_EQ(ply.properties[0].first, "double");
    EXPECT_EQ(ply.values.at("y")[1], -1024.1);
}

TEST_P(Ply, RecordsMayBeLongerThanWhatIsPackedAtOnce) {
    constexpr int kArrays = 9000;  // 36 kB a vertex
    const std::vector<float> values{0, 1, 2, 3};
    WriteOptions options{.encoding = GetParam()};
    for (int i = 0; i < kArrays; ++i)
        options.extra.push_back({.name = "a" + std::to_string(i), .values = std::span<const float>(values)});
    const PlyContent ply = written_ply(testing::tetrahedron(), options);
    EXPECT_EQ(ply.values.at("a8999"), (std::vector<double>{0, 1, 2, 3}));
    EXPECT_EQ(ply.triangles.size(), 4U);
    EXPECT_TRUE(ply.read_to_the_end);
}

TEST_P(Ply, AnEmptyMeshIsAValidFile) {
    const PlyContent ply = written_ply({}, {.encoding = GetParam()});
    EXPECT_TRUE(ply.triangles.empty());
    EXPECT_TRUE(ply.read_to_the_end);
}

INSTANTIATE_TEST_SUITE_P(Encodings, Ply, ::testing::Values(Encoding::Binary, Encoding::Text),
                         [](const auto& test) { return test.param == Encoding::Binary ? "Binary" : "Text"; });

TEST(PlyHeader, NamesFormatVersionAndCounts) {
    const PlyContent ply = written_ply(testing::tetrahedron(), {});
    const std::vector<std::string> expected{"ply",
                                            "format binary_little_endian 1.0",
                                            std::string("comment meniscus ") + kVersion,
                                            "comment lengths in angstrom",
                                            "element vertex 4",
                                            "property float x",
                                            "property float y",
                                            "property float z",
                                            "element face 4",
                                            "property list uchar int vertex_indices",
                                            "end_header"};
    EXPECT_EQ(ply.header, expected);
}

}  // namespace
}  // namespace meniscus
