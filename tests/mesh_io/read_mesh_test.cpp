// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/read_mesh.h"

#include <zlib.h>

#include <random>

#include "meniscus/write.h"
#include "small_files.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

// Every format that we write, in every encoding.
struct Written {
    const char* name;
    Encoding encoding = Encoding::Binary;
};
constexpr std::array kWritten{Written{"a.ply"}, Written{"b.ply", Encoding::Text}, Written{"a.obj"},
                              Written{"a.stl"}, Written{"b.stl", Encoding::Text}, Written{"a.off"},
                              Written{"a.glb"}};

Mesh two_spheres() {
    Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 1.5}, 0.3);
    append(mesh, turned_inside_out(projected_sphere({.centre = {1, 2, 3}, .radius = 0.7}, 0.3)));
    mesh.normals.clear();
    return mesh;
}

TEST(ReadMesh, WhatWeWriteReadsBackAsTheSameManifold) {
    const ScratchFolder folder;
    const Mesh mesh = two_spheres();
    for (const Written& written : kWritten) {
        write_mesh(folder / written.name, mesh, {.encoding = written.encoding});
        const Mesh read = read_mesh(folder / written.name);
        expect_closed_manifold(read);
        EXPECT_EQ(read.vertices.size(), mesh.vertices.size()) << written.name;
        EXPECT_EQ(read.triangles.size(), mesh.triangles.size()) << written.name;
        EXPECT_NEAR(area_of(read), area_of(mesh), 1e-4) << written.name;
        EXPECT_NEAR(volume_of(read), volume_of(mesh), 1e-4) << written.name;
        EXPECT_EQ(euler_characteristic_of(read), euler_characteristic_of(mesh)) << written.name;
    }
}

TEST(ReadMesh, PairsOfMsmsReadBackToTheirThreeDecimals) {
    const ScratchFolder folder;
    Mesh mesh = two_spheres();
    mesh.normals.assign(mesh.vertices.size(), {0.0, 0.0, 1.0});
    mesh.atoms.assign(mesh.vertices.size(), 0);
    mesh.patches.assign(mesh.vertices.size(), PatchKind::Contact);
    write_mesh(folder / "a.vert", mesh);
    for (const char* name : {"a.vert", "a.face"}) {
        const Mesh read = read_mesh(folder / name);
        expect_closed_manifold(read);
        ASSERT_EQ(read.triangles, mesh.triangles) << name;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            ASSERT_LT(norm(read.vertices[v] - mesh.vertices[v]), 0.001) << name;
    }
}

TEST(ReadMesh, MeshesOfNothingReadBack) {
    const ScratchFolder folder;
    for (const Written& written : kWritten) {
        write_mesh(folder / written.name, {}, {.encoding = written.encoding});
        EXPECT_TRUE(read_mesh(folder / written.name).triangles.empty()) << written.name;
    }
}

TEST(ReadMesh, GzipIsTakenByName) {
    const ScratchFolder folder;
    const std::string text = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    gzFile file = gzopen((folder / "a.off.gz").c_str(), "wb");
    gzwrite(file, text.data(), static_cast<unsigned>(text.size()));
    gzclose(file);
    EXPECT_EQ(read_mesh(folder / "a.off.gz").triangles.size(), 1U);
}

TEST(ReadMesh, KnowsMeshesByTheirNames) {
    for (const char* name : {"a.ply", "d.x/A.STL", "a.off.gz", "a.vert", "a.face"}) EXPECT_TRUE(is_mesh_file(name));
    for (const char* name : {"a.pdb", "a.xyzr", "ply", "a.ply/b", "", "-"}) EXPECT_FALSE(is_mesh_file(name));
    EXPECT_THROW(read_mesh("a.pdb"), UsageError);
    EXPECT_THROW(read_mesh("/no/such/a.ply"), InputError);
    expect_error("v 0 0 2e9\n", "a.obj", "a coordinate beyond 1e9");
}

// Whatever is in a file, it is a mesh whose corners exist, or it is refused.
void read_garbage(const std::string& path, const std::string& content) {
    write_file(path, content);
    try {
        const Mesh mesh = read_mesh(path);
        for (const Triangle& t : mesh.triangles)
            for (const VertexId v : t) ASSERT_LT(v, mesh.vertices.size());
        for (const Vec3& v : mesh.vertices) ASSERT_TRUE(is_finite(v));
    } catch (const InputError& error) {
        ASSERT_EQ(std::string(error.what()).find(path), 0U) << error.what();
    }
}

TEST(ReadMesh, FilesThatAreCutOffOrDamagedAreRefusedOrRead) {
    const ScratchFolder folder;
    std::mt19937 random(1);
    for (const Written& written : kWritten) {
        const std::string path = folder / written.name;
        write_mesh(path, tetrahedron(), {.encoding = written.encoding});
        const std::string whole = read_file(path);
        for (std::size_t size = 0; size < whole.size(); size += 1 + whole.size() / 50)
            read_garbage(path, whole.substr(0, size));
        for (int i = 0; i < 60; ++i) {
            std::string damaged = whole;
            for (int k = 0; k < 3; ++k) damaged[random() % damaged.size()] = static_cast<char>(random());
            read_garbage(path, damaged);
        }
    }
}

}  // namespace
}  // namespace meniscus::testing
