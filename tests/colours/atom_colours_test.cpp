// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/atom_colours.h"

#include <gtest/gtest.h>

#include <array>
#include <set>
#include <string>

#include "colours/palettes.h"

namespace meniscus {
namespace {

constexpr std::array kAminoAcids{"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY", "HIS", "ILE",
                                 "LEU", "LYS", "MET", "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL"};

TEST(AtomColours, EveryAminoAcidHasItsOwn) {
    std::set<std::uint32_t> seen;
    for (const char* name : kAminoAcids) {
        const Colour c = residue_colour(name);
        EXPECT_NE(c, kNeutral) << name;
        seen.insert(c.red << 16U | c.green << 8U | c.blue);
    }
    EXPECT_EQ(seen.size(), kAminoAcids.size());
}

TEST(AtomColours, OtherNamesOfAResidueMeanTheSame) {
    EXPECT_EQ(residue_colour("HIE"), residue_colour("HIS"));
    EXPECT_EQ(residue_colour("MSE"), residue_colour("MET"));
    EXPECT_EQ(residue_colour("DA"), residue_colour("A"));
    EXPECT_EQ(residue_colour("DT5"), residue_colour("THY"));
    EXPECT_NE(residue_colour("DC"), residue_colour("DG"));
    EXPECT_EQ(residue_colour("HEM"), kNeutral);
    EXPECT_EQ(residue_colour(""), kNeutral);
}

TEST(AtomColours, HydropathyIsThatOfKyteAndDoolittle) {
    EXPECT_EQ(hydropathy("ILE"), 4.5);
    EXPECT_EQ(hydropathy("ARG"), -4.5);
    EXPECT_EQ(hydropathy("CYX"), 2.5);
    EXPECT_FALSE(hydropathy("DA").has_value());
    double sum = 0.0;
    for (const char* name : kAminoAcids) sum += hydropathy(name).value();
    EXPECT_NEAR(sum, -9.8, 1e-9);
}

TEST(AtomColours, ElementsThatAreNotToldApartAreNeutral) {
    EXPECT_EQ(element_colour("O"), rgb(0xF00000));
    EXPECT_NE(element_colour("C"), element_colour("N"));
    EXPECT_EQ(element_colour("XE"), kNeutral);
    EXPECT_EQ(element_colour(""), kNeutral);
}

TEST(AtomColours, ConfidenceHasFourBands) {
    EXPECT_EQ(plddt_band(95.0).colour, rgb(0x0053D6));
    EXPECT_EQ(&plddt_band(90.0), &plddt_band(70.5));
    EXPECT_EQ(&plddt_band(70.0), &plddt_band(50.5));
    EXPECT_EQ(plddt_band(50.0).colour, rgb(0xFF7D45));
}

}  // namespace
}  // namespace meniscus
