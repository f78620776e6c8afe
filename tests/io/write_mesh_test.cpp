// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/mesh_readers.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;
using testing::tetrahedron;

TEST(WriteMesh, SuffixChoosesTheFormatWhateverItsCase) {
    const ScratchFolder folder;
    write_mesh(folder / "a.PLY", tetrahedron());
    write_mesh(folder / "b.c.Obj", tetrahedron());
    write_mesh(folder / "c.stl", tetrahedron());
    write_mesh(folder / "d.off", tetrahedron());
    EXPECT_TRUE(testing::read_file(folder / "a.PLY").starts_with("ply\n"));
    EXPECT_TRUE(testing::read_file(folder / "b.c.Obj").starts_with("# meniscus"));
    EXPECT_EQ(testing::read_file(folder / "c.stl").size(), 84U + 4U * 50U);
    EXPECT_TRUE(testing::read_file(folder / "d.off").starts_with("OFF\n"));
}

TEST(WriteMesh, UnknownSuffixesAreRefused) {
    const ScratchFolder folder;
    for (const char* name : {"a.pl", "a", "a.ply.gz", ".plyx", "a."})
        EXPECT_THROW(write_mesh(folder / name, tetrahedron()), UsageError) << name;
    EXPECT_THROW(write_mesh("x.ply/a", tetrahedron()), UsageError);
    EXPECT_TRUE(folder.listing().empty());
}

TEST(WriteMesh, ArraysOfAnotherSizeAreRefused) {
    const ScratchFolder folder;
    Mesh mesh = tetrahedron();
    mesh.normals.resize(3);
    EXPECT_THROW(write_mesh(folder / "a.ply", mesh), UsageError);
    mesh = tetrahedron();
    mesh.atoms.resize(5);
    EXPECT_THROW(write_mesh(folder / "a.ply", mesh), UsageError);
    mesh = tetrahedron();
    mesh.shape_indices.resize(3);
    EXPECT_THROW(write_mesh(folder / "a.ply", mesh), UsageError);
    const std::vector<float> values(3);
    const std::span<const float> view(values);
    EXPECT_THROW(write_mesh(folder / "a.ply", tetrahedron(), {.extra = {{.name = "depth", .values = view}}}),
                 UsageError);
    EXPECT_TRUE(folder.listing().empty());
}

TEST(WriteMesh, EveryArrayNeedsANameOfItsOwn) {
    const ScratchFolder folder;
    for (const char* name : {"x", "atom", "Alpha", "area", "phi", "PHI"}) {
        Mesh mesh = tetrahedron();
        mesh.areas.resize(4);
        mesh.values = {{"phi", {1, 2, 3, 4}}, {name, {1, 2, 3, 4}}};
        EXPECT_THROW(write_mesh(folder / "a.ply", mesh), UsageError) << name;
    }
    EXPECT_TRUE(folder.listing().empty());
}

TEST(WriteMesh, AStructureTellsTheResiduesOfVertices) {
    const ScratchFolder folder;
    Mesh mesh = tetrahedron();
    mesh.atoms = {0, 1, 1, 0};
    Structure structure;
    structure.labels.resize(2);
    structure.labels[1].residue = 7;
    write_mesh(folder / "a.ply", mesh, {.structure = &structure});
    EXPECT_EQ(testing::read_ply(testing::read_file(folder / "a.ply")).values.at("residue"), (std::vector<double>{0, 7, 7, 0}));
    structure.labels.resize(1);
    EXPECT_THROW(write_mesh(folder / "a.ply", mesh, {.structure = &structure}), UsageError);
}

TEST(WriteMesh, NamesThatAreNoWordsAreRefused) {
    const ScratchFolder folder;
    const std::vector<float> values(4);
    for (const char* name : {"", "two words", "line\n"}) {
        const VertexArray array{.name = name, .values = std::span<const float>(values)};
        EXPECT_THROW(write_mesh(folder / "a.ply", tetrahedron(), {.extra = {array}}), UsageError);
    }
    EXPECT_TRUE(folder.listing().empty());
}

TEST(WriteMesh, FailureLeavesNoFile) {
    const ScratchFolder folder;
    EXPECT_THROW(write_mesh(folder / "none/a.ply", tetrahedron()), OutputError);
    std::filesystem::create_directory(folder / "sub.ply");
    EXPECT_THROW(write_mesh(folder / "sub.ply", tetrahedron()), OutputError);
    EXPECT_EQ(folder.listing(), std::vector<std::string>{"sub.ply"});
}

TEST(WriteMesh, WrittenTrianglesKeepThreeDistinctPositions) {
    // Through many nodes, so that vertices come as close to each other as they ever do.
    const ScratchFolder folder;
    const Mesh mesh = testing::extracted_sphere({.centre = {1000, 0, 0}, .radius = 2.5}, 0.05);
    write_mesh(folder / "a.obj", mesh);
    const Mesh read = testing::read_obj(testing::read_file(folder / "a.obj"));
    for (const auto& [a, b, c] : read.triangles) {
        EXPECT_NE(read.vertices[a], read.vertices[b]);
        EXPECT_NE(read.vertices[b], read.vertices[c]);
        EXPECT_NE(read.vertices[c], read.vertices[a]);
    }
}

}  // namespace
}  // namespace meniscus
