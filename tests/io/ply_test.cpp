// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/ply.h"

#include <gtest/gtest.h>

#include <limits>

#include "meniscus/version.h"
#include "support/mesh_readers.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::PlyContent;
using testing::ScratchFolder;

PlyContent round_trip(const Mesh& mesh, const WriteOptions& options) {
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
    }
    return mesh;
}

class Ply : public ::testing::TestWithParam<Encoding> {};

TEST_P(Ply, EverythingReadsBack) {
    const Mesh mesh = full_mesh();
    std::vector<std::uint32_t> residues(mesh.vertices.size(), std::numeric_limits<std::uint32_t>::max());
    std::vector<float> depths(mesh.vertices.size(), -1.25F);
    const PlyContent ply =
        round_trip(mesh, {.encoding = GetParam(),
                          .extra = {{.name = "residue", .values = std::span<const std::uint32_t>(residues)},
                                    {.name = "depth", .values = std::span<const float>(depths)}}});
    const std::vector<std::pair<std::string, std::string>> expected{
        {"float", "x"},       {"float", "y"},      {"float", "z"},    {"float", "nx"},
        {"float", "ny"},      {"float", "nz"},     {"uint", "atom"},  {"uchar", "patch"},
        {"int", "component"}, {"uint", "residue"}, {"float", "depth"}};
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
        EXPECT_EQ(ply.values.at("residue")[v], 4294967295.0);
        EXPECT_EQ(ply.values.at("depth")[v], -1.25);
    }
}

TEST_P(Ply, OnlyWhatTheMeshHasIsWritten) {
    const PlyContent ply = round_trip(testing::tetrahedron(), {.encoding = GetParam()});
    EXPECT_EQ(ply.properties.size(), 3U);
    EXPECT_EQ(ply.values.at("y"), (std::vector<double>{1, -1, 1, -1}));
    EXPECT_TRUE(ply.read_to_the_end);
}

TEST_P(Ply, FarFromTheOriginCoordinatesAreDoubles) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[1].y = -1024.1;
    const PlyContent ply = round_trip(mesh, {.encoding = GetParam()});
    EXPECT_EQ(ply.properties[0].first, "double");
    EXPECT_EQ(ply.values.at("y")[1], -1024.1);
}

TEST_P(Ply, AnEmptyMeshIsAValidFile) {
    const PlyContent ply = round_trip({}, {.encoding = GetParam()});
    EXPECT_TRUE(ply.triangles.empty());
    EXPECT_TRUE(ply.read_to_the_end);
}

INSTANTIATE_TEST_SUITE_P(Encodings, Ply, ::testing::Values(Encoding::Binary, Encoding::Text),
                         [](const auto& test) { return test.param == Encoding::Binary ? "Binary" : "Text"; });

TEST(PlyHeader, NamesFormatVersionAndCounts) {
    const PlyContent ply = round_trip(testing::tetrahedron(), {});
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
