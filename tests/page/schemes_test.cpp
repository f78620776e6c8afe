// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/schemes.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "page/decoding.h"

namespace meniscus::page {
namespace {

using testing::SmallMolecule;

bool offers(const SmallMolecule& molecule, std::string_view id, const ColourOptions& first = {}) {
    const auto schemes = offered_schemes(molecule.mesh, molecule.structure, first);
    return std::any_of(schemes.begin(), schemes.end(), [&](const OfferedScheme& s) { return s.id == id; });
}

TEST(Schemes, WhatTellsNothingApartIsNotOffered) {
    SmallMolecule molecule;
    EXPECT_TRUE(offers(molecule, "chain") && offers(molecule, "bfactor") && offers(molecule, "component"));
    molecule.structure.residues[1].chain = "A";
    for (AtomLabel& label : molecule.structure.labels) label.b_factor = 0.0;
    molecule.mesh.components.assign(molecule.mesh.vertices.size(), 0);
    molecule.mesh.mean_curvatures.clear();
    for (const char* id : {"chain", "bfactor", "component", "curvature", "plddt"})
        EXPECT_FALSE(offers(molecule, id)) << id;
    for (const char* id : {"single", "patch", "depth"}) EXPECT_TRUE(offers(molecule, id)) << id;
}

TEST(Schemes, WhatWasAskedForIsAlwaysOfferedWithItsRange) {
    const SmallMolecule molecule;
    EXPECT_FALSE(offers(molecule, "plddt"));
    EXPECT_TRUE(offers(molecule, "plddt", {ColourScheme::Plddt}));
    const ColourOptions narrow{ColourScheme::Curvature, ValueRange{-0.1, 0.1}};
    for (const OfferedScheme& s : offered_schemes(molecule.mesh, molecule.structure, narrow))
        EXPECT_EQ(s.options.range.has_value(), s.options.scheme == ColourScheme::Curvature) << s.id;
}

TEST(Schemes, ValuesAreOfferedByTheirNameOnce) {
    SmallMolecule molecule;
    const std::size_t n = molecule.mesh.vertices.size();
    molecule.mesh.values = {{"phi", std::vector<float>(n)}, {"bfactor", std::vector<float>(n)}};
    const ColourOptions first{.scheme = ColourScheme::Value, .range = ValueRange{-5.0, 5.0}, .value = "phi"};
    std::size_t of_b_factors = 0;
    for (const OfferedScheme& s : offered_schemes(molecule.mesh, molecule.structure, first)) {
        of_b_factors += s.id == "bfactor" ? 1U : 0U;
        EXPECT_EQ(s.options.range.has_value(), s.id == "phi") << s.id;
        EXPECT_EQ(s.options.scheme == ColourScheme::Value, s.id == "phi") << s.id;
    }
    EXPECT_EQ(of_b_factors, 1U);
    EXPECT_TRUE(offers(molecule, "phi"));
}

TEST(Schemes, ConfidenceIsKnownByOneValuePerResidue) {
    SmallMolecule molecule;
    Structure& s = molecule.structure;
    s.labels.push_back(s.labels[1]);
    s.atoms.centres.push_back({0, 0, 50});
    s.atoms.radii.push_back(1.0);
    s.labels[0].b_factor = 91.0;
    s.labels[1].b_factor = s.labels[2].b_factor = 40.0;
    EXPECT_TRUE(offers(molecule, "plddt"));
    s.labels[2].b_factor = 41.0;
    EXPECT_FALSE(offers(molecule, "plddt"));
}

/// The colours that the browser would give the vertices are those of colour_vertices().
TEST(Schemes, AtomsHaveTheColoursOfTheLibrary) {
    const SmallMolecule molecule;
    for (const OfferedScheme& scheme : offered_schemes(molecule.mesh, molecule.structure, {})) {
        Streams streams;
        const auto block = describe(scheme, molecule.mesh, molecule.structure, streams);
        const std::vector<Colour> expected = colour_vertices(molecule.mesh, molecule.structure, scheme.options);
        if (block["kind"] != "atom") continue;
        for (std::size_t v = 0; v < expected.size(); ++v) {
            const auto channel = [&](std::size_t k) {
                return static_cast<std::uint8_t>(streams.bytes()[2 * k + molecule.mesh.atoms[v]]);
            };
            const auto& patch = block["patches"][static_cast<std::size_t>(molecule.mesh.patches[v])];
            const std::string colour =
                patch.is_null() ? hex({channel(0), channel(1), channel(2)}) : patch.get<std::string>();
            ASSERT_EQ(colour, hex(expected[v])) << scheme.id;
        }
    }
}

TEST(Schemes, ComponentsHaveTheColoursOfTheLibrary) {
    const SmallMolecule molecule;
    const OfferedScheme scheme{"component", "", {ColourScheme::Component}};
    Streams streams;
    const auto block = describe(scheme, molecule.mesh, molecule.structure, streams);
    const std::vector<Colour> expected = colour_vertices(molecule.mesh, molecule.structure, scheme.options);
    EXPECT_EQ(block["colours"][0], hex(expected.front()));
    EXPECT_EQ(block["colours"][1], hex(expected.back()));
}

TEST(Schemes, ValuesHaveARampOfNineColours) {  // as viewer/shaders.js expects
    const SmallMolecule molecule;
    for (const ColourScheme scheme : {ColourScheme::Curvature, ColourScheme::Depth}) {
        Streams streams;
        const auto block = describe({"x", "", {scheme}}, molecule.mesh, molecule.structure, streams);
        EXPECT_EQ(block["kind"], "value");
        EXPECT_EQ(block["ramp"].size(), 9U);
    }
}

}  // namespace
}  // namespace meniscus::page
