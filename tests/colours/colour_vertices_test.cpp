// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "colours/atom_colours.h"
#include "colours/depths.h"
#include "colours/palettes.h"
#include "colours/small_meshes.h"
#include "meniscus/colours.h"
#include "meniscus/errors.h"
#include "tables/small_complex.h"

namespace meniscus {
namespace {

using testing::small_complex;
using testing::vertex_per_atom;

TEST(ColourVertices, EveryVertexHasTheColourOfItsAtomAndPatch) {
    const auto colours = colour_vertices(vertex_per_atom(), small_complex(), {.scheme = ColourScheme::ResiduePatch});
    EXPECT_EQ(colours[0], residue_colour("ALA"));
    EXPECT_EQ(colours[1], colours[2]);
    EXPECT_EQ(colours[3], residue_colour("MET"));
    EXPECT_EQ(colours[0].alpha, 255);
}

TEST(ColourVertices, CurvatureIsSymmetricAboutWhite) {
    Mesh mesh = vertex_per_atom();
    mesh.mean_curvatures = {-5.0F, -0.7F, 0.0F, 0.35F, 0.7F, std::numeric_limits<float>::infinity()};
    const auto colours = colour_vertices(mesh, small_complex(), {.scheme = ColourScheme::Curvature});
    EXPECT_EQ(colours[0], colours[1]);
    EXPECT_EQ(colours[2], diverging_ramp()[4]);
    EXPECT_NEAR(colours[3].red, diverging_ramp()[6].red, 1);
    EXPECT_EQ(colours[5], diverging_ramp().back());
    const auto wide =
        colour_vertices(mesh, small_complex(), {.scheme = ColourScheme::Curvature, .range = ValueRange{-1.4, 1.4}});
    EXPECT_EQ(wide[0], colours[0]);
    EXPECT_NEAR(wide[4].red, colours[3].red, 1);
}

TEST(ColourVertices, DepthHasTheColdRamp) {
    const auto [mesh, two] = testing::groove();
    const auto colours = colour_vertices(mesh, two, {.scheme = ColourScheme::Depth});
    EXPECT_EQ(colours[0], cold_ramp().front());
    EXPECT_EQ(colours[1], ramp_colour(cold_ramp(), depths(mesh, ExactSurface(two.atoms))[1] / kDepthProbe));
}

TEST(ColourVertices, OuterPiecesAreAlikeAndCavitiesAreNot) {
    const auto [mesh, first_of] = testing::two_outer_pieces_and_two_cavities();
    const auto colours = colour_vertices(mesh, {}, {.scheme = ColourScheme::Component});
    EXPECT_EQ(colours.front(), colours[first_of[1]]);
    EXPECT_NE(colours[first_of[2]], colours.front());
    EXPECT_NE(colours[first_of[2]], colours[first_of[3]]);
    EXPECT_NE(colours[first_of[3]], colours.front());
}

TEST(ColourVertices, PocketsHaveTheColoursOfTheirRanks) {
    Mesh mesh = vertex_per_atom();
    EXPECT_THROW(colour_vertices(mesh, small_complex(), {.scheme = ColourScheme::Pocket}), UsageError);
    mesh.values.push_back({kPocketValues, std::vector<float>(mesh.vertices.size(), 2.0F)});
    mesh.values[0].values[0] = 1.0F;
    mesh.values[0].values[1] = std::numeric_limits<float>::quiet_NaN();
    const auto colours = colour_vertices(mesh, small_complex(), {.scheme = ColourScheme::Pocket});
    EXPECT_EQ(colours[0], distinct_colour(1));
    EXPECT_EQ(colours[1], kNeutral);
    EXPECT_EQ(colours[2], distinct_colour(2));
    EXPECT_EQ(colours[2], pocket_colour(2.0F));
}

TEST(ColourVertices, WhatDoesNotFitIsRefused) {
    const Structure structure = small_complex();
    Mesh mesh = vertex_per_atom();
    EXPECT_THROW(colour_vertices(mesh, structure, {.scheme = ColourScheme::Curvature}), UsageError);
    EXPECT_THROW(colour_vertices(mesh, structure, {.scheme = ColourScheme::Component}), UsageError);
    EXPECT_THROW(colour_vertices(mesh, structure, {.scheme = ColourScheme::Chain, .range = ValueRange{}}), UsageError);
    EXPECT_THROW(colour_vertices(mesh, structure, {.scheme = ColourScheme::Depth, .range = ValueRange{1.0, 1.0}}),
                 UsageError);
    mesh.atoms[2] = 6;
    EXPECT_THROW(colour_vertices(mesh, structure), UsageError);
    mesh.atoms.clear();
    EXPECT_THROW(colour_vertices(mesh, structure), UsageError);
}

TEST(ColourVertices, ValuesAreRedBelowZeroBlueAboveAndGreyWhereThereIsNone) {
    Mesh mesh = vertex_per_atom();
    mesh.values = {{"phi", {-1.0F, 0.0F, 1.0F, NAN, 0.5F, 9.0F}}};
    const ColourOptions options{.scheme = ColourScheme::Value, .range = ValueRange{-1.0, 1.0}, .value = "phi"};
    const auto colours = colour_vertices(mesh, small_complex(), options);
    EXPECT_EQ(colours[0], diverging_ramp().back());
    EXPECT_EQ(colours[2], diverging_ramp().front());
    EXPECT_EQ(colours[1], ramp_colour(diverging_ramp(), 0.5));
    EXPECT_EQ(colours[3], kNeutral);
    EXPECT_EQ(colours[5], colours[2]);
    const auto by_own_range = colour_vertices(mesh, small_complex(), {.scheme = ColourScheme::Value, .value = "phi"});
    EXPECT_EQ(by_own_range[5], potential_ramp().back());
    EXPECT_NE(by_own_range[2], potential_ramp().back());
    EXPECT_THROW(colour_vertices(mesh, small_complex(), {.scheme = ColourScheme::Value, .value = "psi"}), UsageError);
    mesh.values[0].values.pop_back();
    EXPECT_THROW(colour_vertices(mesh, small_complex(), options), UsageError);
}

TEST(PassageColour, IsLighterTheWiderTheTunnelIs) {
    EXPECT_EQ(passage_colour(0.3), passage_colour(1.0));
    EXPECT_EQ(passage_colour(16.0), passage_colour(40.0));
    const auto light = [](double radius) {
        const Colour c = passage_colour(radius);
        return int{c.red} + int{c.green} + int{c.blue};
    };
    for (const double radius : {1.0, 1.4, 2.0, 4.0, 8.0, 12.0}) EXPECT_LT(light(radius), light(1.2 * radius)) << radius;
    EXPECT_EQ(passage_colour(std::sqrt(8.0)).alpha, 255);
}

TEST(ColourVertices, AnEmptyMeshHasNoColours) {
    for (const ColourScheme scheme : {ColourScheme::Patch, ColourScheme::Component, ColourScheme::Curvature})
        EXPECT_TRUE(colour_vertices({}, small_complex(), {.scheme = scheme}).empty());
}

Colour colour_at(const ColourField& field, const Vec3& point) {
    Colour colour;
    field({&point, 1}, {&colour, 1});
    return colour;
}

TEST(ColourByFeature, BordersAreWhereThePatchesEnd) {
    const Structure structure = small_complex();
    const ExactSurface surface(structure.atoms);
    const ColourOptions options{.scheme = ColourScheme::Chain};
    const ColourField field = colour_by_feature(surface, structure, options);
    EXPECT_EQ(colour_at(field, {-1.7, 0.0, 0.0}), distinct_colour(0));
    EXPECT_EQ(colour_at(field, {3.0, 5.7, 0.0}), distinct_colour(1));
    EXPECT_EQ(colour_at(field, {32.0, 0.0, 0.0}), distinct_colour(2));
    EXPECT_FALSE(colour_by_feature(surface, structure, {.scheme = ColourScheme::Component}));
}

TEST(ColourByFeature, CurvatureIsThatOfTheExactSurface) {
    const Structure structure = small_complex();
    const ExactSurface surface(structure.atoms);
    const ColourField field = colour_by_feature(surface, structure, {.scheme = ColourScheme::Curvature});
    EXPECT_EQ(colour_at(field, {32.0, 0.0, 0.0}), ramp_colour(diverging_ramp(), (0.5 + 0.7) / 1.4));
}

}  // namespace
}  // namespace meniscus
