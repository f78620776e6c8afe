// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/vtp.h"

#include <gtest/gtest.h>

#include <cstring>
#include <string>
#include <vector>

#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;

std::string written_vtp(const Mesh& mesh, const WriteOptions& options) {
    const ScratchFolder folder;
    write_mesh(folder / "a.vtp", mesh, options);
    return testing::read_file(folder / "a.vtp");
}

/// Numbers of an array that the file declares.
template <class T>
std::vector<T> array_of(const std::string& file, const std::string& name) {
    const std::size_t element = file.find("Name=\"" + name + "\"");
    const std::string attribute = "offset=\"";
    const std::size_t offset = std::stoull(file.substr(file.find(attribute, element) + attribute.size()));
    const char* start = file.data() + file.find('_', file.find("<AppendedData")) + 1 + offset;
    std::uint64_t size = 0;
    std::memcpy(&size, start, sizeof size);
    std::vector<T> values(size / sizeof(T));
    std::memcpy(values.data(), start + sizeof size, size);
    return values;
}

TEST(Vtp, EverythingReadsBack) {
    Mesh mesh = testing::tetrahedron();
    mesh.normals.assign(4, {0.0, 0.0, 1.0});
    mesh.atoms = {0, 1, 2, 0xfffffffeU};
    mesh.patches = {PatchKind::Contact, PatchKind::Toroidal, PatchKind::Reentrant, PatchKind::Contact};
    mesh.components = {0, 0, 1, 1};
    mesh.areas = {0.5F, 1.5F, 2.5F, 3.5F};
    const std::vector<std::uint32_t> residues{7, 7, 8, 8};
    const std::vector<Colour> colours{{1, 2, 3, 4}, {}, {}, {5, 6, 7, 8}};
    const std::string file = written_vtp(
        mesh, {.extra = {{.name = "residue", .values = std::span<const std::uint32_t>(residues)}}, .colours = colours});
    EXPECT_EQ(array_of<float>(file, "Points")[3], static_cast<float>(mesh.vertices[1].x));
    EXPECT_EQ(array_of<float>(file, "Normals"), (std::vector<float>{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}));
    EXPECT_EQ(array_of<std::uint32_t>(file, "atom"), mesh.atoms);
    EXPECT_EQ(array_of<std::uint8_t>(file, "patch"), (std::vector<std::uint8_t>{0, 1, 2, 0}));
    EXPECT_EQ(array_of<std::uint32_t>(file, "component"), mesh.components);
    EXPECT_EQ(array_of<float>(file, "area"), mesh.areas);
    EXPECT_EQ(array_of<std::uint32_t>(file, "residue"), residues);
    const auto channels = array_of<std::uint8_t>(file, "colors");
    EXPECT_EQ(channels.size(), 16U);
    EXPECT_EQ(channels[15], 8);
    const auto corners = array_of<std::int64_t>(file, "connectivity");
    for (std::size_t i = 0; i < corners.size(); ++i) EXPECT_EQ(corners[i], mesh.triangles[i / 3][i % 3]);
    EXPECT_EQ(array_of<std::int64_t>(file, "offsets"), (std::vector<std::int64_t>{3, 6, 9, 12}));
    EXPECT_TRUE(file.ends_with("</AppendedData>\n</VTKFile>\n"));
}

TEST(Vtp, FarFromTheOriginCoordinatesAreDouble) {
    Mesh mesh = testing::tetrahedron();
    for (Vec3& v : mesh.vertices) v.x += 5000.125;
    EXPECT_EQ(array_of<double>(written_vtp(mesh, {}), "Points")[0], mesh.vertices[0].x);
}

TEST(Vtp, NamesAreEscaped) {
    const std::vector<float> values(4);
    const VertexArray array{.name = "a<b&c\"", .values = std::span<const float>(values)};
    EXPECT_NE(written_vtp(testing::tetrahedron(), {.extra = {array}}).find("Name=\"a&lt;b&amp;c&quot;\""),
              std::string::npos);
}

}  // namespace
}  // namespace meniscus
