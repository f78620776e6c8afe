// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/legend.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "colours/atom_colours.h"
#include "colours/palettes.h"
#include "colours/small_meshes.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

using testing::small_complex;
using testing::vertex_per_atom;
using Entries = std::vector<LegendEntry>;

Legend legend_of(ColourScheme scheme, const Structure& structure = small_complex()) {
    return make_legend(vertex_per_atom(), structure, {.scheme = scheme});
}

TEST(Legend, OneColourNeedsNone) {
    const Legend legend = legend_of(ColourScheme::Single);
    EXPECT_TRUE(legend.title.empty() && legend.entries.empty() && legend.ramp.empty());
}

TEST(Legend, ChainsAreInTheOrderOfTheFileAndOnlyThoseOnTheMesh) {
    const Entries all{{"A", distinct_colour(0)}, {"B", distinct_colour(1)}, {"LONG", distinct_colour(2)}};
    EXPECT_EQ(legend_of(ColourScheme::Automatic).entries, all);
    Mesh mesh = vertex_per_atom();
    mesh.atoms.assign(mesh.vertices.size(), 5);
    EXPECT_EQ(make_legend(mesh, small_complex()).entries, Entries{all.back()});
}

TEST(Legend, AChainWithoutNameIsADash) {
    Structure structure = small_complex();
    structure.residues[0].chain = "";
    EXPECT_EQ(legend_of(ColourScheme::Chain, structure).entries.front().label, "-");
}

TEST(Legend, EveryVertexHasTheColourOfAnEntry) {
    for (const ColourScheme scheme : {ColourScheme::Patch, ColourScheme::Element, ColourScheme::Chain,
                                      ColourScheme::Residue, ColourScheme::ResiduePatch, ColourScheme::Plddt}) {
        const Entries entries = legend_of(scheme).entries;
        for (const Colour& colour : colour_vertices(vertex_per_atom(), small_complex(), {.scheme = scheme}))
            EXPECT_TRUE(std::any_of(entries.begin(), entries.end(), [&](const auto& e) { return e.colour == colour; }));
    }
}

TEST(Legend, ElementsBeginWithCarbonAndAreWrittenAsChemistsDo) {
    Structure structure = small_complex();
    structure.labels[0].element = "ZN";
    structure.labels[1].element = "O";
    structure.labels[2].element = "";
    const Entries expected{
        {"C", element_colour("C")}, {"O", element_colour("O")}, {"Zn", element_colour("ZN")}, {"other", kNeutral}};
    EXPECT_EQ(legend_of(ColourScheme::Element, structure).entries, expected);
}

TEST(Legend, ResiduesGoByTheirKindAminoAcidsFirst) {
    Structure structure = small_complex();
    structure.residues[0].name = "DG";
    structure.residues[2].name = "LIG";
    const Entries expected{{"HIS", residue_colour("HIS")},
                           {"MET", residue_colour("MET")},
                           {"G", residue_colour("G")},
                           {"other", kNeutral}};
    EXPECT_EQ(legend_of(ColourScheme::Residue, structure).entries, expected);
}

TEST(Legend, PatchesThatAreNoContactShareAnEntryBesideResidues) {
    const Entries entries = legend_of(ColourScheme::ResiduePatch).entries;
    EXPECT_EQ(entries.back().label, "toroidal, reentrant");
    EXPECT_EQ(std::count(entries.begin(), entries.end(), entries.back()), 1);
}

TEST(Legend, CavitiesAreNumberedAfterTheOuterPieces) {
    const Mesh mesh = testing::two_outer_pieces_and_two_cavities().first;
    const Entries expected{{"outer", kPlain}, {"cavity 1", distinct_colour(1)}, {"cavity 2", distinct_colour(2)}};
    EXPECT_EQ(make_legend(mesh, {}, {.scheme = ColourScheme::Component}).entries, expected);
    EXPECT_TRUE(make_legend({}, {}, {.scheme = ColourScheme::Component}).entries.empty());
}

TEST(Legend, ValuesHaveARampOverTheRangeInForce) {
    Structure structure = small_complex();
    for (AtomLabel& label : structure.labels) label.b_factor = label.serial;
    const Legend b_factor = legend_of(ColourScheme::BFactor, structure);
    EXPECT_EQ(b_factor.range, (ValueRange{1.0, 6.0}));
    EXPECT_TRUE(std::ranges::equal(b_factor.ramp, warm_ramp()));
    EXPECT_TRUE(b_factor.entries.empty());
    const Legend depth = make_legend({}, {}, {.scheme = ColourScheme::Depth, .range = ValueRange{1.0, 2.0}});
    EXPECT_EQ(depth.range, (ValueRange{1.0, 2.0}));
}

TEST(Legend, ValuesHaveTheirNameAndWhereSomeAreMissingAnEntry) {
    Mesh mesh;
    mesh.values = {{"score", {1.0F, 3.0F}}, {"phi", {-1.0F, NAN}}};
    const Legend score = make_legend(mesh, {}, {.scheme = ColourScheme::Value, .value = "score"});
    EXPECT_EQ(score.title, "score");
    EXPECT_EQ(score.range, (ValueRange{1.0, 3.0}));
    EXPECT_TRUE(std::ranges::equal(score.ramp, cold_ramp()));
    EXPECT_TRUE(score.entries.empty());
    const Legend phi =
        make_legend(mesh, {}, {.scheme = ColourScheme::Value, .range = ValueRange{-5.0, 5.0}, .value = "phi"});
    EXPECT_TRUE(std::ranges::equal(phi.ramp, potential_ramp()));
    EXPECT_EQ(phi.entries, (std::vector<LegendEntry>{{"no value", kNeutral}}));
}

TEST(Legend, WhatHasNoHydropathyStandsBesideTheRamp) {
    EXPECT_TRUE(legend_of(ColourScheme::Hydrophobicity).entries.empty());
    Structure structure = small_complex();
    structure.residues[3].name = "DA";
    const Entries expected{{"other", kNeutral}};
    EXPECT_EQ(legend_of(ColourScheme::Hydrophobicity, structure).entries, expected);
}

TEST(Legend, ConfidenceFallsFromBandToBand) {
    Structure structure = small_complex();
    for (AtomLabel& label : structure.labels) label.b_factor = 20.0 * label.serial;
    const Entries entries = legend_of(ColourScheme::Plddt, structure).entries;
    ASSERT_EQ(entries.size(), 4U);
    EXPECT_EQ(entries.front().label, "above 90, very high");
    EXPECT_EQ(entries.back().label, "below 50, very low");
}

TEST(Legend, AMeshWithoutTheArraysIsRefused) {
    EXPECT_THROW(make_legend(vertex_per_atom(), small_complex(), {.scheme = ColourScheme::Component}), UsageError);
    Mesh mesh = vertex_per_atom();
    mesh.patches.clear();
    EXPECT_THROW(make_legend(mesh, small_complex(), {.scheme = ColourScheme::Patch}), UsageError);
}

}  // namespace
}  // namespace meniscus
