// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/ligand_bodies.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/shapes.h"
#include "support/small_ligand.h"

namespace meniscus {
namespace {

using testing::carbon_monoxide;

constexpr Colour kGrey{200, 200, 200, 255};
const Mesh kSphere = testing::projected_sphere({.centre = {}, .radius = 3.0}, 0.5);

TEST(LigandBodies, AreRoundBallsAndHalfSticksOfTheirAtoms) {
    const Ligands ligands = carbon_monoxide({4.0, 0.0, 0.0});
    const Bodies bodies = ligand_bodies(ligands, kSphere, {});
    ASSERT_EQ(bodies.mesh.vertices.size(), 2 * 162U + 2 * 32U);
    ASSERT_EQ(bodies.colours.size(), bodies.mesh.vertices.size());
    for (std::size_t v = 0; v < bodies.mesh.vertices.size(); ++v) {
        const Vec3& p = bodies.mesh.vertices[v];
        if (v < 324) {
            const std::size_t atom = v / 162;
            EXPECT_NEAR(norm(p - ligands.centres[atom]), ball_radius(ligands.labels[atom]), 1e-12);
        } else {
            EXPECT_NEAR(std::hypot(p.y, p.z), kStickRadius, 1e-12);
        }
    }
    for (const auto& [a, b, c] : bodies.mesh.triangles) {
        const Vec3& corner = bodies.mesh.vertices[a];
        const Vec3 out = cross(bodies.mesh.vertices[b] - corner, bodies.mesh.vertices[c] - corner);
        for (const VertexId v : {a, b, c}) EXPECT_GT(dot(out, Vec3(bodies.mesh.normals[v])), 0.0);
    }
}

TEST(LigandBodies, CarbonIsFarFromTheColoursOfTheSurfaceOxygenIsRed) {
    const Ligands ligands = carbon_monoxide({4.0, 0.0, 0.0});
    const Colour usual = ligand_colours(ligands, std::vector{kGrey})[0];
    const Colour other = ligand_colours(ligands, std::vector{kGrey, usual})[0];
    EXPECT_NE(usual, other);
    for (const auto& surface : {std::vector{kGrey}, std::vector{usual}})
        EXPECT_EQ(ligand_colours(ligands, surface)[1], (Colour{255, 13, 13, 255}));
}

TEST(LigandBodies, ThoseOfTheSurfaceAreHiddenByIt) {
    Ligands ligands = carbon_monoxide({4.0, 0.0, 0.0});
    ligands.in_surface = true;
    EXPECT_TRUE(ligand_bodies(ligands, kSphere, {}).mesh.triangles.empty());
    EXPECT_TRUE(ligand_bodies({}, kSphere, {}).mesh.triangles.empty());
}

TEST(LigandsNear, AreAtMostSixAngstromsAwayAsAPlainSearchFinds) {
    for (const double x : {-11.0, -8.9, 0.0, 8.9, 9.1, 12.0, 1e5}) {
        const Ligands ligands = carbon_monoxide({x, 0.3, -0.2});
        bool near = false;
        for (const Vec3& vertex : kSphere.vertices)
            for (const Vec3& centre : ligands.centres) near |= norm(centre - vertex) <= 6.0;
        EXPECT_EQ(ligands_near(ligands, kSphere).centres.size(), near ? 2U : 0U) << x;
        EXPECT_EQ(ligands_near(ligands, kSphere).bonds.size(), near ? 1U : 0U) << x;
    }
}

TEST(LigandsNear, KeepTheirNumbersTogether) {
    Ligands ligands = carbon_monoxide({50.0, 0.0, 0.0});
    const Ligands near = carbon_monoxide({4.0, 0.0, 0.0});
    ligands.centres.insert(ligands.centres.end(), near.centres.begin(), near.centres.end());
    for (AtomLabel label : near.labels) {
        label.residue = 1;
        ligands.labels.push_back(label);
    }
    ligands.residues.push_back({.chain = "B", .name = "XYZ", .number = 8});
    ligands.bonds.push_back({2, 3});
    const Ligands part = ligands_near(ligands, kSphere);
    EXPECT_EQ(part.residues.at(0).name, "XYZ");
    EXPECT_EQ(part.labels.at(1).residue, 0U);
    EXPECT_EQ(part.bonds, (std::vector<std::array<std::uint32_t, 2>>{{0, 1}}));
}

}  // namespace
}  // namespace meniscus
