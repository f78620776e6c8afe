// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/page_data.h"

#include <gtest/gtest.h>

#include <limits>

#include "page/decoding.h"
#include "support/small_ligand.h"

namespace meniscus::page {
namespace {

using testing::DecodedPage;
using testing::SmallMolecule;

TEST(PageData, VerticesAndTrianglesReadBack) {
    const SmallMolecule molecule;
    const DecodedPage page(page_data(molecule.mesh, molecule.structure, {}, {}));
    const std::vector<Triangle> triangles = testing::triangles(page.stream("triangles"));
    const std::vector<std::int64_t> y = testing::sums(page.stream("y"));
    const double low = page.info["low"][1];
    ASSERT_EQ(triangles.size(), molecule.mesh.triangles.size());
    EXPECT_EQ(page.info["triangles"], triangles.size());
    EXPECT_EQ(page.info["vertices"], y.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_NEAR(low + kQuantum * static_cast<double>(y[triangles[t][k]]),
                        molecule.mesh.vertices[molecule.mesh.triangles[t][k]].y, 0.5 * kQuantum + 1e-9);
}

TEST(PageData, AtomsAndResiduesReadBack) {
    const SmallMolecule molecule;
    const DecodedPage page(page_data(molecule.mesh, molecule.structure, {}, {}));
    const double low = page.info["atoms"]["low"][0];
    const std::vector<std::int64_t> x = testing::sums(page.stream("atom-x"));
    for (std::size_t i = 0; i < 2; ++i)
        EXPECT_NEAR(low + kQuantum * static_cast<double>(x[i]), molecule.structure.atoms.centres[i].x, 0.5 * kQuantum);
    EXPECT_EQ(page.info["atoms"]["names"], (nlohmann::json{"CA", "O5'"}));
    EXPECT_EQ(page.info["residues"]["list"][0], (nlohmann::json{0, 0, -3, "B"}));
    EXPECT_EQ(page.info["residues"]["chains"][1], "A-2");
    EXPECT_EQ(testing::sums(page.stream("atom-bfactor")), (std::vector<std::int64_t>{1250, 0}));
}

TEST(PageData, FirstSchemeAndViewAreThoseAskedFor) {
    const SmallMolecule molecule;
    const PageOptions options{.colours = {ColourScheme::Patch},
                              .viewpoint = Viewpoint{{1, 0, 0}, {0, 1, 0}},
                              .projection = Projection::Perspective};
    const DecodedPage page(page_data(molecule.mesh, molecule.structure, options, {}));
    EXPECT_EQ(page.info["scheme"], "patch");
    EXPECT_EQ(page.info["view"]["towards"], (nlohmann::json{1.0, 0.0, 0.0}));
    EXPECT_EQ(page.info["view"]["perspective"], true);
    EXPECT_EQ(DecodedPage(page_data(molecule.mesh, molecule.structure, {}, {})).info["scheme"], "chain");
}

TEST(PageData, SaysWhichLigandsMayFillCavities) {
    SmallMolecule molecule;
    EXPECT_EQ(DecodedPage(page_data(molecule.mesh, molecule.structure, {}, {})).info["ligandsLeftOut"], "");
    molecule.structure.left_out_ligands = {{"HEM", 4}, {"PO4", 1}};
    EXPECT_EQ(DecodedPage(page_data(molecule.mesh, molecule.structure, {}, {})).info["ligandsLeftOut"], "4 HEM, 1 PO4");
}

TEST(PageData, LigandsReadBack) {
    SmallMolecule molecule;
    const std::string without = page_data(molecule.mesh, molecule.structure, {}, {});
    EXPECT_FALSE(DecodedPage(without).info.contains("ligands"));
    const Vec3 carbon = molecule.structure.atoms.centres[0] + Vec3{0.0, 0.0, 4.0};
    molecule.structure.ligands = meniscus::testing::carbon_monoxide(carbon);
    EXPECT_EQ(page_data(molecule.mesh, molecule.structure, {.ligands = false}, {}), without);
    const DecodedPage page(page_data(molecule.mesh, molecule.structure, {}, {}));
    const nlohmann::json& ligands = page.info["ligands"];
    EXPECT_EQ(ligands["atoms"]["count"], 2);
    EXPECT_EQ(ligands["atoms"]["elements"], (nlohmann::json{"C", "O"}));
    EXPECT_EQ(ligands["residues"]["list"], (nlohmann::json{{0, 0, 7, ""}}));
    EXPECT_EQ(ligands["bonds"], 1);
    EXPECT_EQ(ligands["text"], "1 CMO");
    EXPECT_EQ(ligands["inSurface"], false);
    EXPECT_EQ(testing::sums(page.stream("ligand-bonds")), (std::vector<std::int64_t>{0, 1}));
    EXPECT_EQ(page.stream("ligand-colours").size(), 6U);
    const std::vector<std::int64_t> z = testing::sums(page.stream("ligand-z"));
    EXPECT_NEAR(ligands["atoms"]["low"][2].get<double>() + kQuantum * static_cast<double>(z[1]), carbon.z, kQuantum);
}

TEST(PageData, PocketsReadBack) {
    SmallMolecule molecule;
    const std::string without = page_data(molecule.mesh, molecule.structure, {}, {});
    EXPECT_FALSE(DecodedPage(without).info.contains("pockets"));
    Mesh bodies;
    bodies.vertices = molecule.mesh.vertices;
    bodies.normals = molecule.mesh.normals;
    bodies.components.assign(bodies.vertices.size(), 0);
    bodies.triangles = {molecule.mesh.triangles[1]};
    molecule.mesh.values.push_back({kPocketValues, std::vector<float>(molecule.mesh.vertices.size(), 1.0F)});
    molecule.mesh.values[0].values[0] = std::numeric_limits<float>::quiet_NaN();
    const PageOptions options{.colours = {ColourScheme::Pocket},
                              .pockets = {{.name = "1",
                                           .colour = {255, 0, 128, 255},
                                           .volume = 12.345,
                                           .mouths = 2,
                                           .centre = {1, 2, 3},
                                           .lining = "A:SER 1"}},
                              .bodies = &bodies};
    const DecodedPage page(page_data(molecule.mesh, molecule.structure, options, {}));
    const nlohmann::json& pocket = page.info["pockets"][0];
    EXPECT_EQ(pocket["colour"], "#ff0080");
    EXPECT_EQ(pocket["volume"], 12.35);
    EXPECT_EQ(pocket["mouths"], 2);
    EXPECT_EQ(pocket["centre"], (nlohmann::json{1.0, 2.0, 3.0}));
    EXPECT_EQ(page.info["bodies"]["triangles"], 1);
    EXPECT_EQ(page.info["bodies"]["vertices"], 3);
    const std::vector<std::int64_t> y = testing::sums(page.stream("body-y"));
    EXPECT_NEAR(page.info["low"][1].get<double>() + kQuantum * static_cast<double>(y[0]),
                bodies.vertices[bodies.triangles[0][0]].y, kQuantum);
    EXPECT_EQ(page.info["scheme"], "pocket");
    for (const nlohmann::json& scheme : page.info["schemes"])
        if (scheme["id"] == "pocket") {
            EXPECT_EQ(scheme["kind"], "class");
            EXPECT_EQ(scheme["colours"].size(), 1U);
            EXPECT_EQ(scheme["none"], "#cccccc");
            EXPECT_EQ(scheme["legend"]["entries"][0][0], "pocket 1");
            EXPECT_EQ(scheme["legend"]["entries"][1][0], "no pocket");
        }
}

TEST(PageData, TunnelsReadBack) {
    SmallMolecule molecule;
    EXPECT_FALSE(DecodedPage(page_data(molecule.mesh, molecule.structure, {}, {})).info.contains("ways"));
    Bodies tubes;
    tubes.mesh.vertices = molecule.mesh.vertices;
    tubes.mesh.normals = molecule.mesh.normals;
    tubes.mesh.components.assign(tubes.mesh.vertices.size(), 0);
    tubes.mesh.triangles = {molecule.mesh.triangles[1]};
    for (std::size_t v = 0; v < tubes.mesh.vertices.size(); ++v)
        tubes.colours.push_back({static_cast<std::uint8_t>(v), 7, 9, 255});
    const PageOptions options{.ways = {{.name = "tunnel 2.1",
                                        .from = "pocket 2",
                                        .rank = 1,
                                        .colour = Colour{255, 0, 128, 255},
                                        .radius = 1.23456,
                                        .bottleneck = {1, 2, 3},
                                        .profile = {{0.0, 2.0}, {0.25, 1.23456}}},
                                       {.name = "pore", .from = "pore"}},
                              .tubes = &tubes};
    const DecodedPage page(page_data(molecule.mesh, molecule.structure, options, {}));
    const nlohmann::json& way = page.info["ways"]["list"][0];
    EXPECT_EQ(way["name"], "tunnel 2.1");
    EXPECT_EQ(way["colour"], "#ff0080");
    EXPECT_EQ(way["radius"], 1.235);
    EXPECT_EQ(way["bottleneck"], (nlohmann::json{1.0, 2.0, 3.0}));
    EXPECT_EQ(way["profile"], (nlohmann::json{{0.0, 2.0}, {0.25, 1.235}}));
    EXPECT_TRUE(page.info["ways"]["list"][1]["colour"].is_null());
    EXPECT_EQ(page.info["tubes"], (nlohmann::json{{"triangles", 1}, {"vertices", 3}}));
    const std::string_view colours = page.stream("tube-colours");
    ASSERT_EQ(colours.size(), 9U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(static_cast<std::uint8_t>(colours[i]), tubes.mesh.triangles[0][i]);
        EXPECT_EQ(colours[3 + i], 7);
    }
}

TEST(PageData, NamesThatAreNoTextDoNotBreakIt) {
    SmallMolecule molecule;
    molecule.structure.residues[0].name = "\xFF\x01";
    const DecodedPage page(page_data(molecule.mesh, molecule.structure, {}, {}));
    EXPECT_EQ(page.info["residues"]["names"][0], "\xEF\xBF\xBD\x01");
}

}  // namespace
}  // namespace meniscus::page
