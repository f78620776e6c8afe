// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/glb.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "core/srgb.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "support/glb_reader.h"
#include "support/mesh_checks.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::GlbContent;
using testing::ScratchFolder;

GlbContent written_glb(const Mesh& mesh, const WriteOptions& options) {
    const ScratchFolder folder;
    write_mesh(folder / "a.glb", mesh, options);
    return testing::read_glb(testing::read_file(folder / "a.glb"));
}

Mesh full_mesh() {
    Mesh mesh = testing::projected_sphere({.centre = {1, 2, 3}, .radius = 1.5}, 0.3);
    for (std::uint32_t v = 0; v < mesh.vertices.size(); ++v) {
        mesh.atoms.push_back(16777216U - v);
        mesh.patches.push_back(static_cast<PatchKind>(v % 3));
        mesh.components.push_back(v % 2);
        mesh.areas.push_back(0.01F * static_cast<float>(v));
        mesh.mean_curvatures.push_back(1.0F / 3.0F - static_cast<float>(v));
        mesh.gaussian_curvatures.push_back(1e-7F * static_cast<float>(v));
        mesh.shape_indices.push_back(v % 2 == 0 ? -1.0F : 0.25F);
    }
    return mesh;
}

TEST(Glb, EverythingReadsBack) {
    const Mesh mesh = full_mesh();
    const std::vector<std::uint32_t> residues(mesh.vertices.size(), 77);
    const GlbContent glb =
        written_glb(mesh, {.extra = {{.name = "residue", .values = std::span<const std::uint32_t>(residues)}}});
    EXPECT_EQ(glb.attributes.size(), 10U);
    EXPECT_EQ(glb.triangles, mesh.triangles);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const auto value = [&](const char* name) { return glb.attributes.at(name).at(v).at(0); };
        EXPECT_EQ(value("POSITION"), static_cast<float>(mesh.vertices[v].x));
        EXPECT_EQ(glb.attributes.at("POSITION")[v][2], static_cast<float>(mesh.vertices[v].z));
        EXPECT_EQ(glb.attributes.at("NORMAL")[v][1], static_cast<float>(mesh.normals[v].y));
        EXPECT_EQ(value("_ATOM"), mesh.atoms[v]);
        EXPECT_EQ(value("_PATCH"), static_cast<double>(mesh.patches[v]));
        EXPECT_EQ(value("_COMPONENT"), mesh.components[v]);
        EXPECT_EQ(value("_AREA"), mesh.areas[v]);
        EXPECT_EQ(value("_MEAN_CURVATURE"), mesh.mean_curvatures[v]);
        EXPECT_EQ(value("_GAUSSIAN_CURVATURE"), mesh.gaussian_curvatures[v]);
        EXPECT_EQ(value("_SHAPE_INDEX"), mesh.shape_indices[v]);
        EXPECT_EQ(value("_RESIDUE"), 77.0);
    }
}

TEST(Glb, LigandsAreANodeBesideTheSurface) {
    const Mesh mesh = full_mesh();
    Bodies ball{.mesh = testing::projected_sphere({.centre = {9, 2, 3}, .radius = 0.5}, 0.2), .colours = {}};
    ball.colours.assign(ball.mesh.vertices.size(), Colour{255, 0, 0, 255});
    const GlbContent glb = written_glb(mesh, {.beside = &ball});
    EXPECT_EQ(glb.triangles, mesh.triangles);
    EXPECT_EQ(glb.attributes.size(), 9U);
    EXPECT_EQ(glb.json["scenes"][0]["nodes"], (nlohmann::json{0, 1}));
    EXPECT_EQ(glb.json["nodes"][1], (nlohmann::json{{"mesh", 1}, {"name", "ligands"}}));
    ASSERT_EQ(glb.ligands.at("POSITION").size(), ball.mesh.vertices.size());
    for (std::size_t v = 0; v < ball.mesh.vertices.size(); ++v) {
        EXPECT_EQ(glb.ligands.at("POSITION")[v][0], static_cast<float>(ball.mesh.vertices[v].x));
        EXPECT_EQ(glb.ligands.at("NORMAL")[v][2], static_cast<float>(ball.mesh.normals[v].z));
        EXPECT_EQ(glb.ligands.at("COLOR_0")[v], (std::vector<double>{1.0, 0.0, 0.0, 1.0}));
    }
    const Bodies none;
    EXPECT_EQ(written_glb(mesh, {.beside = &none}).json, written_glb(mesh, {}).json);
}

TEST(Glb, NamedMeshesAreNodesInTheirColours) {
    const Mesh mesh = full_mesh();
    Bodies ball{.mesh = testing::projected_sphere({.centre = {9, 2, 3}, .radius = 0.5}, 0.2), .colours = {}};
    ball.colours.assign(ball.mesh.vertices.size(), Colour{255, 0, 0, 255});
    const std::vector<NamedMesh> named{
        {"pocket 1", ball.mesh, {0, 255, 0, 51}}, {"pocket 2", {}, {}}, {"pocket 3", ball.mesh, {0, 0, 255, 255}}};
    const GlbContent glb = written_glb(mesh, {.beside = &ball, .named = named});
    EXPECT_EQ(glb.triangles, mesh.triangles);
    EXPECT_EQ(glb.json["scenes"][0]["nodes"], (nlohmann::json{0, 1, 2, 3}));
    EXPECT_EQ(glb.json["nodes"][2], (nlohmann::json{{"mesh", 2}, {"name", "pocket 1"}}));
    EXPECT_EQ(glb.json["nodes"][3]["name"], "pocket 3");
    const nlohmann::json primitive = glb.json["meshes"][2]["primitives"][0];
    EXPECT_EQ(primitive["material"], 2);
    EXPECT_EQ(glb.json["accessors"][primitive["attributes"]["POSITION"].get<int>()]["count"],
              ball.mesh.vertices.size());
    EXPECT_EQ(glb.json["accessors"][primitive["indices"].get<int>()]["count"], 3 * ball.mesh.triangles.size());
    const nlohmann::json clear = glb.json["materials"][2];
    EXPECT_EQ(clear["alphaMode"], "BLEND");
    EXPECT_EQ(clear["pbrMetallicRoughness"]["baseColorFactor"], (nlohmann::json{0.0, 1.0, 0.0, 0.2}));
    EXPECT_FALSE(glb.json["materials"][3].contains("alphaMode"));
}

TEST(Glb, NamedMeshesMayHaveColoursOfTheirVertices) {
    const Mesh ball = testing::projected_sphere({.centre = {9, 2, 3}, .radius = 0.5}, 0.2);
    std::vector<Colour> colours(ball.vertices.size(), Colour{255, 0, 0, 255});
    const std::vector<NamedMesh> named{{"pore", ball, {0, 255, 0, 51}, std::move(colours)}};
    const GlbContent glb = written_glb(full_mesh(), {.named = named});
    EXPECT_EQ(glb.json["nodes"][1]["name"], "pore");
    const nlohmann::json primitive = glb.json["meshes"][1]["primitives"][0];
    const nlohmann::json accessor = glb.json["accessors"][primitive["attributes"]["COLOR_0"].get<int>()];
    EXPECT_EQ(accessor["count"], ball.vertices.size());
    const nlohmann::json material = glb.json["materials"][1];
    EXPECT_FALSE(material.contains("alphaMode"));
    EXPECT_FALSE(material["pbrMetallicRoughness"].contains("baseColorFactor"));
}

TEST(Glb, TheMeshIsStillClosed) {
    const GlbContent glb = written_glb(full_mesh(), {});
    Mesh read;
    for (const auto& p : glb.attributes.at("POSITION")) read.vertices.push_back({p[0], p[1], p[2]});
    read.triangles = glb.triangles;
    testing::expect_closed_manifold(read);
    EXPECT_NEAR(testing::volume_of(read), testing::volume_of(full_mesh()), 1e-4);
}

TEST(Glb, ColoursAreLinearAndEveryByteIsTold) {
    const Mesh mesh = testing::projected_sphere({.centre = {}, .radius = 3.0}, 0.4);
    ASSERT_GT(mesh.vertices.size(), 256U);
    std::vector<Colour> colours(mesh.vertices.size());
    for (std::size_t v = 0; v < colours.size(); ++v)
        colours[v] = {static_cast<std::uint8_t>(v), 188, static_cast<std::uint8_t>(255 - v), 255};
    const GlbContent glb = written_glb(mesh, {.colours = colours});
    for (std::size_t v = 0; v < colours.size(); ++v) {
        const std::vector<double>& rgba = glb.attributes.at("COLOR_0")[v];
        EXPECT_EQ(std::lround(255.0 * srgb_from_linear(rgba[0])), colours[v].red);
        EXPECT_EQ(std::lround(255.0 * srgb_from_linear(rgba[2])), colours[v].blue);
        EXPECT_NEAR(rgba[1], 0.5, 0.01);
        EXPECT_EQ(rgba[3], 1.0);
    }
}

TEST(Glb, TellsBoundsUnitAndProbe) {
    const GlbContent glb = written_glb(testing::tetrahedron(), {.probe = 1.4});
    const auto& asset = glb.json.at("asset");
    EXPECT_EQ(asset.at("version"), "2.0");
    EXPECT_EQ(asset.at("generator"), std::string("Meniscus ") + kVersion);
    EXPECT_EQ(asset.at("extras").at("units"), "angstrom");
    EXPECT_EQ(asset.at("extras").at("probe"), 1.4);
    const auto& position = glb.json.at("accessors").at(0);
    EXPECT_EQ(position.at("min"), (nlohmann::json{-1.0, -1.0, -1.0}));
    EXPECT_EQ(position.at("max"), (nlohmann::json{1.0, 1.0, 1.0}));
    EXPECT_EQ(glb.json.at("materials").at(0).at("doubleSided"), false);
    EXPECT_FALSE(glb.json.at("nodes").at(0).contains("matrix"));
}

TEST(Glb, AnEmptyMeshIsAnEmptyScene) {
    const GlbContent glb = written_glb({}, {});
    EXPECT_FALSE(glb.json.contains("meshes"));
    EXPECT_EQ(glb.json.at("scenes").size(), 1U);
}

TEST(Glb, WhatFloatCannotHoldIsRefusedAndLeavesNoFile) {
    const ScratchFolder folder;
    Mesh mesh = testing::tetrahedron();
    mesh.atoms.assign(4, 16777217U);
    EXPECT_THROW(write_mesh(folder / "a.glb", mesh), LimitError);
    mesh.atoms.clear();
    mesh.areas.assign(4, std::numeric_limits<float>::quiet_NaN());
    EXPECT_THROW(write_mesh(folder / "a.glb", mesh), UsageError);
    mesh.areas.clear();
    mesh.vertices[2].y = 1e300;
    EXPECT_THROW(write_mesh(folder / "a.glb", mesh), UsageError);
    EXPECT_TRUE(folder.listing().empty());
}

TEST(Glb, WhereThereIsNoValueStandsANumberThatTheExtrasName) {
    Mesh mesh = testing::tetrahedron();
    constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
    mesh.values = {{"score", {1.0F, kNone, -2.0F, kNone}}, {"phi", {1.0F, 2.0F, 3.0F, 4.0F}}};
    const GlbContent glb = written_glb(mesh, {});
    const auto& missing = glb.json.at("asset").at("extras").at("missing");
    EXPECT_EQ(missing.size(), 1U);
    const double number = missing.at("_SCORE");
    EXPECT_EQ(number, double{std::numeric_limits<float>::lowest()});
    EXPECT_EQ(glb.attributes.at("_SCORE").at(1).at(0), number);
    EXPECT_EQ(glb.attributes.at("_SCORE").at(2).at(0), -2.0);
    EXPECT_EQ(glb.attributes.at("_PHI").at(3).at(0), 4.0);
    const ScratchFolder folder;
    mesh.values[0].values[0] = std::numeric_limits<float>::infinity();
    EXPECT_THROW(write_mesh(folder / "a.glb", mesh), UsageError);
}

TEST(Glb, NamesThatItCannotHoldAreRefused) {
    const ScratchFolder folder;
    const std::vector<float> values(4);
    for (const char* name : {"a.b", "Å", "area"}) {
        Mesh mesh = testing::tetrahedron();
        mesh.areas = values;
        const VertexArray array{.name = name, .values = std::span<const float>(values)};
        EXPECT_THROW(write_mesh(folder / "a.glb", mesh, {.extra = {array}}), UsageError) << name;
    }
    EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace meniscus
