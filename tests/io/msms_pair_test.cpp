// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/msms_pair.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <sstream>

#include "meniscus/errors.h"
#include "support/mesh_readers.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::read_file;
using testing::ScratchFolder;

Mesh labelled_tetrahedron() {
    Mesh mesh = testing::tetrahedron();
    mesh.normals.assign(4, {0.0F, 0.6F, -0.8F});
    mesh.atoms = {0, 1, 1, 2};
    mesh.patches = {PatchKind::Contact, PatchKind::Contact, PatchKind::Toroidal, PatchKind::Reentrant};
    return mesh;
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

TEST(MsmsPair, LinesAreThoseOfMsms) {
    const ScratchFolder folder;
    Mesh mesh = labelled_tetrahedron();
    mesh.vertices[0] = {-1234.5678, 0.0004, -0.0004};
    const std::vector<std::string> names{"N_GLY_1", "CA_GLY_1", "C_GLY_1"};
    write_msms(folder / "a", mesh, {.title = "a.xyzrn", .spheres = 3, .density = 3.0, .probe = 1.5, .names = names});
    const auto vert = lines_of(read_file(folder / "a.vert"));
    ASSERT_EQ(vert.size(), 7U);
    EXPECT_EQ(vert[0], "# MSMS solvent excluded surface vertices for a.xyzrn");
    EXPECT_EQ(vert[1], "#vertex #sphere density probe_r");
    EXPECT_EQ(vert[2], "      4       3  3.00  1.50");
    EXPECT_EQ(vert[3], "-1234.568     0.000     0.000     0.000     0.600    -0.800       0       1  3 N_GLY_1");
    EXPECT_TRUE(vert[5].ends_with("       0       2  1 CA_GLY_1")) << vert[5];
    EXPECT_TRUE(vert[6].ends_with("       0       3  2 C_GLY_1")) << vert[6];
    const auto face = lines_of(read_file(folder / "a.face"));
    ASSERT_EQ(face.size(), 7U);
    EXPECT_EQ(face[1], "#faces  #sphere density probe_r");
    EXPECT_EQ(face[2], "      4       3  3.00  1.50");
    EXPECT_EQ(face[3].size(), 30U) << face[3];
}

TEST(MsmsPair, ATriangleIsOfTheKindOfTwoCornersElseToroidal) {
    const ScratchFolder folder;
    Mesh mesh = labelled_tetrahedron();
    mesh.triangles = {{0, 1, 3}, {1, 2, 3}};
    write_msms(folder / "a", mesh, {.header = MsmsHeader::None});
    EXPECT_EQ(read_file(folder / "a.face"), "     1      2      4  3      1\n     2      3      4  1      1\n");
    EXPECT_EQ(lines_of(read_file(folder / "a.vert")).size(), 4U);
    EXPECT_TRUE(lines_of(read_file(folder / "a.vert"))[0].ends_with("  3 "));  // nine fields
}

TEST(MsmsPair, TheHeaderOfNanoShaperHasTheCountAlone) {
    const ScratchFolder folder;
    write_msms(folder / "a", labelled_tetrahedron(), {.header = MsmsHeader::CountOnly});
    const auto vert = lines_of(read_file(folder / "a.vert"));
    EXPECT_EQ(vert[1], "#vertex");
    EXPECT_EQ(vert[2], "4");
    EXPECT_EQ(vert.size(), 7U);
}

TEST(MsmsPair, PlacesThatRoundToTheSameOneAreParted) {
    const ScratchFolder folder;
    Mesh mesh = labelled_tetrahedron();
    for (Vec3& vertex : mesh.vertices) vertex = {1.0001, 2.0, 3.0};
    mesh.vertices[3].x = 1.001;  // the place that the second would move to
    write_msms(folder / "a", mesh, {.header = MsmsHeader::None});
    std::set<std::string> places;
    for (const std::string& line : lines_of(read_file(folder / "a.vert"))) places.insert(line.substr(0, 29));
    EXPECT_EQ(places.size(), 4U);
}

TEST(MsmsPair, WriteMeshTakesNamesAndTheDensityFromWhatItHas) {
    const ScratchFolder folder;
    Structure structure;
    structure.file = "a.pdb";
    structure.atoms = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {1.0, 1.0, 1.0}};
    structure.labels.resize(3);
    structure.residues = {{"A", "GLY", 7, 'B'}};
    for (std::size_t i = 0; i < 3; ++i) structure.labels[i].name = std::string("N") + std::to_string(i);
    write_mesh(folder / "a.vert", labelled_tetrahedron(), {.structure = &structure, .probe = 1.4});
    const auto vert = lines_of(read_file(folder / "a.vert"));
    EXPECT_EQ(vert[0], "# MSMS solvent excluded surface vertices for a.pdb");
    EXPECT_TRUE(vert[2].starts_with("      4       3 ") && vert[2].ends_with("  1.40")) << vert[2];
    EXPECT_TRUE(vert[3].ends_with(" N0_GLY_7B_A")) << vert[3];
    for (AtomLabel& label : structure.labels) label.name.clear();
    write_mesh(folder / "b.vert", labelled_tetrahedron(), {.structure = &structure});
    EXPECT_TRUE(lines_of(read_file(folder / "b.vert"))[3].ends_with("  3 "));
}

TEST(MsmsPair, WhatHasNoRoomIsRefusedAndLeavesNothing) {
    const ScratchFolder folder;
    EXPECT_THROW(write_msms(folder / "a", testing::tetrahedron(), {}), UsageError);
    Mesh mesh = labelled_tetrahedron();
    const std::vector<std::string> few{"A"};
    EXPECT_THROW(write_msms(folder / "a", mesh, {.names = few}), UsageError);
    const std::vector<std::string> blank{"A", "B C", "D"};
    EXPECT_THROW(write_msms(folder / "a", mesh, {.names = blank}), UsageError);
    EXPECT_THROW(write_msms(folder / "a", mesh, {.spheres = std::size_t{1} << 31U}), LimitError);
    mesh.vertices[2].z = -10000.0;
    EXPECT_THROW(write_msms(folder / "a", mesh, {}), LimitError);
    EXPECT_TRUE(folder.listing().empty());
}

// The .vert is found to be full when its last bytes are written.
TEST(MsmsPair, OneFileThatFailsLeavesTheOtherAsItWas) {
    const ScratchFolder folder;
    std::filesystem::create_symlink("/dev/full", folder / "a.vert");
    EXPECT_THROW(write_msms(folder / "a", labelled_tetrahedron(), {}), OutputError);
    EXPECT_EQ(folder.listing().size(), 1U);
}

TEST(MsmsPair, AnEmptyMeshIsTwoHeaders) {
    const ScratchFolder folder;
    write_msms(folder / "a", {}, {.title = "none"});
    EXPECT_EQ(lines_of(read_file(folder / "a.vert")).size(), 3U);
    EXPECT_EQ(lines_of(read_file(folder / "a.face")).size(), 3U);
}

}  // namespace
}  // namespace meniscus
