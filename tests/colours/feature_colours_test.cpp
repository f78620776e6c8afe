// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/feature_colours.h"

#include <gtest/gtest.h>

#include "colours/atom_colours.h"
#include "colours/palettes.h"
#include "support/colour_vision.h"
#include "tables/small_complex.h"

namespace meniscus {
namespace {

using testing::small_complex;

FeatureColours colours_of(ColourScheme scheme, const Structure& structure = small_complex()) {
    return feature_colours(structure, {.scheme = scheme}).value();
}

TEST(FeatureColours, SeveralChainsAreColouredByChain) {
    Structure structure = small_complex();
    EXPECT_EQ(scheme_in_force(ColourScheme::Automatic, structure), ColourScheme::Chain);
    EXPECT_EQ(scheme_in_force(ColourScheme::Patch, structure), ColourScheme::Patch);
    const FeatureColours by_chain = colours_of(ColourScheme::Automatic);
    EXPECT_EQ(by_chain.of_atom[0], by_chain.of_atom[3]);
    EXPECT_NE(by_chain.of_atom[3], by_chain.of_atom[4]);
    EXPECT_NE(by_chain.of_atom[4], by_chain.of_atom[5]);
    for (Residue& residue : structure.residues) residue.chain = "A";
    EXPECT_EQ(scheme_in_force(ColourScheme::Automatic, structure), ColourScheme::Single);
    EXPECT_EQ(colours_of(ColourScheme::Automatic, structure).of_atom, std::vector<Colour>(6, kPlain));
}

TEST(FeatureColours, PatchesAreToldApartByTheColourBlindToo) {
    std::vector<Colour> patches;
    for (const auto& colour : colours_of(ColourScheme::Patch).of_patch) patches.push_back(colour.value());
    EXPECT_GT(testing::smallest_difference(patches), 12.5);
}

TEST(FeatureColours, OneColourMayBeChosen) {
    const Colour tomato{255, 99, 71};
    const auto colours = feature_colours(small_complex(), {.scheme = ColourScheme::Single, .colour = tomato});
    EXPECT_EQ(colours->of_atom, std::vector<Colour>(6, tomato));
}

TEST(FeatureColours, PatchesGoBeforeAtoms) {
    const FeatureColours patch = colours_of(ColourScheme::Patch);
    EXPECT_EQ(patch.at(0, PatchKind::Toroidal), patch.at(5, PatchKind::Toroidal));
    EXPECT_NE(patch.at(0, PatchKind::Contact), patch.at(0, PatchKind::Reentrant));
    const FeatureColours both = colours_of(ColourScheme::ResiduePatch);
    EXPECT_EQ(both.at(0, PatchKind::Contact), residue_colour("ALA"));
    EXPECT_EQ(both.at(0, PatchKind::Toroidal), both.at(5, PatchKind::Reentrant));
    EXPECT_EQ(colours_of(ColourScheme::Residue).at(0, PatchKind::Reentrant), residue_colour("ALA"));
}

TEST(FeatureColours, ValuesBeyondTheRangeGetItsEnds) {
    Structure structure = small_complex();
    for (std::size_t i = 0; i < structure.labels.size(); ++i) structure.labels[i].b_factor = static_cast<double>(i);
    EXPECT_EQ(default_range(ColourScheme::BFactor, structure), (ValueRange{0.0, 5.0}));
    const auto colours =
        feature_colours(structure, {.scheme = ColourScheme::BFactor, .range = ValueRange{1.0, 3.0}}).value().of_atom;
    EXPECT_EQ(colours[0], colours[1]);
    EXPECT_NE(colours[1], colours[2]);
    EXPECT_EQ(colours[3], colours[5]);
    EXPECT_EQ(colours[5], warm_ramp().back());
}

TEST(FeatureColours, EqualValuesHaveEqualColours) {
    EXPECT_EQ(place_in({2.0, 2.0}, 2.0), 0.0);
    EXPECT_EQ(colours_of(ColourScheme::BFactor).of_atom, std::vector<Colour>(6, warm_ramp().front()));
}

TEST(FeatureColours, AFileOfBareSpheresHasColoursToo) {
    Structure structure = small_complex();
    structure.residues.clear();
    for (AtomLabel& label : structure.labels) label.element.clear();
    for (const ColourScheme scheme : {ColourScheme::Residue, ColourScheme::Hydrophobicity, ColourScheme::Element})
        EXPECT_EQ(colours_of(scheme, structure).of_atom, std::vector<Colour>(6, kNeutral));
    EXPECT_EQ(scheme_in_force(ColourScheme::Automatic, structure), ColourScheme::Single);
}

TEST(FeatureColours, SchemesOfTheVertexHaveNone) {
    for (const ColourScheme scheme : {ColourScheme::Curvature, ColourScheme::Component, ColourScheme::Depth})
        EXPECT_FALSE(feature_colours(small_complex(), {.scheme = scheme}).has_value());
}

}  // namespace
}  // namespace meniscus
