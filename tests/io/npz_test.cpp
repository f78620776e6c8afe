// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/npz.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"
#include "support/unzip.h"

namespace meniscus {
namespace {

using namespace std::string_literals;
using testing::ScratchFolder;

std::map<std::string, std::string> written_npz(const Mesh& mesh, const WriteOptions& options) {
    const ScratchFolder folder;
    write_mesh(folder / "a.npz", mesh, options);
    return testing::unzip(testing::read_file(folder / "a.npz"));
}

/// Header of a .npy file: its dictionary without padding.
std::string description(const std::string& npy) {
    EXPECT_TRUE(npy.starts_with(std::string("\x93NUMPY\x01\x00", 8)));
    const auto length = testing::number_at<std::uint16_t>(npy, 8);
    EXPECT_EQ((10U + length) % 64U, 0U);
    return npy.substr(10, npy.find('}') - 9);
}

template <class T>
std::vector<T> values_of(const std::string& npy) {
    const std::string bytes = npy.substr(10U + testing::number_at<std::uint16_t>(npy, 8));
    std::vector<T> values(bytes.size() / sizeof(T));
    std::memcpy(values.data(), bytes.data(), bytes.size());
    return values;
}

Structure four_atoms() {
    Structure structure;
    structure.file = "a \"b\".pdb";
    structure.radii_set = "united";
    structure.atoms = {{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}}, {1.5, 1.6, 1.7, 1.8}};
    for (const char* name : {"N", "C\xce\xb1", "\xff", "OXT1"})
        structure.labels.push_back({.residue = 0, .name = name, .element = "C"});
    structure.residues.push_back({.chain = "A-2", .name = "ALA", .number = -5});
    return structure;
}

TEST(Npz, MeshArraysReadBack) {
    Mesh mesh = testing::tetrahedron();
    mesh.normals.assign(4, {0.0, 0.0, 1.0});
    mesh.patches.assign(4, PatchKind::Reentrant);
    mesh.values = {{"phi", {1.0F, 2.0F, 3.0F, 4.0F}}};
    const std::vector<Colour> colours(4, {1, 2, 3, 4});
    const auto entries = written_npz(mesh, {.colours = colours});
    EXPECT_EQ(description(entries.at("vertices.npy")), "{'descr': '<f8', 'fortran_order': False, 'shape': (4, 3), }");
    EXPECT_EQ(values_of<double>(entries.at("vertices.npy"))[3], mesh.vertices[1].x);
    EXPECT_EQ(description(entries.at("triangles.npy")), "{'descr': '<i4', 'fortran_order': False, 'shape': (4, 3), }");
    EXPECT_EQ(values_of<Triangle>(entries.at("triangles.npy")), mesh.triangles);
    EXPECT_EQ(description(entries.at("patch.npy")), "{'descr': '|u1', 'fortran_order': False, 'shape': (4,), }");
    EXPECT_EQ(values_of<float>(entries.at("phi.npy")), mesh.values[0].values);
    EXPECT_EQ(values_of<Colour>(entries.at("colors.npy")), colours);
    EXPECT_EQ(values_of<std::uint32_t>(entries.at("layout.npy")), std::vector<std::uint32_t>{1});
    EXPECT_FALSE(entries.contains("atom.npy"));
    EXPECT_FALSE(entries.contains("options.npy"));
}

TEST(Npz, AtomsReadBack) {
    const Structure structure = four_atoms();
    const auto entries = written_npz(testing::tetrahedron(), {.structure = &structure});
    EXPECT_EQ(values_of<Vec3>(entries.at("atom_xyz.npy")), structure.atoms.centres);
    EXPECT_EQ(values_of<double>(entries.at("atom_radius.npy")), structure.atoms.radii);
    EXPECT_EQ(values_of<std::int32_t>(entries.at("atom_resnum.npy")), std::vector<std::int32_t>(4, -5));
    EXPECT_EQ(description(entries.at("atom_name.npy")), "{'descr': '<U4', 'fortran_order': False, 'shape': (4,), }");
    const std::u32string names = U"N\0\0\0Cα\0\0\xfffd\0\0\0OXT1"s;
    EXPECT_EQ(values_of<char32_t>(entries.at("atom_name.npy")), std::vector<char32_t>(names.begin(), names.end()));
}

TEST(Npz, TellsTheOptions) {
    const Structure structure = four_atoms();
    const SurfaceOptions options{.spacing = 0.25};
    const auto entries = written_npz({}, {.structure = &structure, .computed_with = &options});
    const auto letters = values_of<char32_t>(entries.at("options.npy"));
    const std::string text(letters.begin(), letters.end());
    EXPECT_NE(text.find(R"("file":"a \"b\".pdb")"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("spacing":0.25)"), std::string::npos) << text;
    EXPECT_NE(text.find(R"("method":"flow")"), std::string::npos) << text;
}

TEST(Npz, PocketsReadBack) {
    Pockets pockets;
    pockets.pockets.resize(2);
    pockets.pockets[1].score = 3.5;
    pockets.pockets[1].cavity = true;
    pockets.pockets[1].deepest = {1.0, 2.0, 3.0};
    pockets.voxels = {{{1.0, 0.0, 0.0}, 0.25F, 2.0F, 0.5F, 1}, {{2.0, 0.0, 0.0}, 0.75F, 4.0F, 0.125F, kNone}};
    pockets.points = {1};
    pockets.features.resize(1);
    pockets.features[0].back() = 9.0F;
    const ScratchFolder folder;
    write_pocket_arrays(folder / "a.npz", pockets);
    const auto entries = testing::unzip(testing::read_file(folder / "a.npz"));
    EXPECT_EQ(values_of<double>(entries.at("pocket_score.npy")), (std::vector<double>{0.0, 3.5}));
    EXPECT_EQ(values_of<std::int32_t>(entries.at("pocket_cavity.npy")), (std::vector<std::int32_t>{0, 1}));
    EXPECT_EQ(values_of<Vec3>(entries.at("pocket_deepest.npy"))[1], (Vec3{1.0, 2.0, 3.0}));
    EXPECT_EQ(values_of<float>(entries.at("voxel_share.npy")), (std::vector<float>{0.25F, 0.75F}));
    EXPECT_EQ(values_of<std::int32_t>(entries.at("voxel_pocket.npy")), (std::vector<std::int32_t>{1, -1}));
    EXPECT_EQ(values_of<Vec3>(entries.at("point_xyz.npy")), (std::vector<Vec3>{{2.0, 0.0, 0.0}}));
    EXPECT_EQ(values_of<float>(entries.at("point_probability.npy")), std::vector<float>{0.125F});
    EXPECT_EQ(description(entries.at("point_features.npy")),
              "{'descr': '<f4', 'fortran_order': False, 'shape': (1, 43), }");
    EXPECT_EQ(values_of<float>(entries.at("point_features.npy")).back(), 9.0F);
    const auto names = values_of<char32_t>(entries.at("feature_names.npy"));
    EXPECT_EQ(std::u32string(names.data(), 2), U"n6");
}

TEST(Npz, NamesThatWouldBePathsOrTwiceThereAreRefused) {
    const ScratchFolder folder;
    const std::vector<float> values(4);
    for (const char* name : {"../a", "a\\b", "vertices", "layout"}) {
        const VertexArray array{.name = name, .values = std::span<const float>(values)};
        EXPECT_THROW(write_mesh(folder / "a.npz", testing::tetrahedron(), {.extra = {array}}), UsageError) << name;
    }
    EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace meniscus
