// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "radii/aliases.h"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

std::string canonical(std::string_view residue, std::string_view atom) {
    const CanonicalNames names = canonical_names(residue, atom);
    return names.residue + " " + names.atom;
}

TEST(Aliases, ProtonationStatesBecomeTheirAminoAcid) {
    EXPECT_EQ(canonical("HSD", "ND1"), "HIS ND1");
    EXPECT_EQ(canonical("CYX", "SG"), "CYS SG");
    EXPECT_EQ(canonical("GLH", "OE2"), "GLU OE2");
}

TEST(Aliases, AtomNamesOfOtherProgramsBecomeThoseOfTheWwpdb) {
    EXPECT_EQ(canonical("ALA", "OT2"), "ALA OXT");
    EXPECT_EQ(canonical("ILE", "CD"), "ILE CD1");
    EXPECT_EQ(canonical("DA", "C5*"), "DA C5'");
    EXPECT_EQ(canonical("DA", "O1P"), "DA OP1");
    EXPECT_EQ(canonical("THY", "C5M"), "DT C7");
    EXPECT_EQ(canonical("ARG", "1HH2"), "ARG HH21");
}

TEST(Aliases, NamesWithoutAliasStay) {
    EXPECT_EQ(canonical("MSE", "SE"), "MSE SE");
    EXPECT_EQ(canonical("LYS", "CD"), "LYS CD");
    EXPECT_EQ(canonical("", ""), " ");
}

TEST(Aliases, WaterIsKnownUnderTheNamesOfManyPrograms) {
    for (const char* name : {"HOH", "WAT", "DOD", "H2O", "TIP", "TIP3", "TIP4", "SOL", "SPC", "T3P"}) {
        EXPECT_TRUE(is_water(name)) << name;
    }
    EXPECT_FALSE(is_water("SO4"));
    EXPECT_FALSE(is_water(""));
}

TEST(Aliases, TellsAminoAcidsFromNucleotides) {
    EXPECT_TRUE(is_amino_acid("HSE"));
    EXPECT_FALSE(is_amino_acid("DA"));
    EXPECT_TRUE(is_nucleotide("DA"));
    EXPECT_TRUE(is_nucleotide("GUA"));
    EXPECT_FALSE(is_nucleotide("GLY"));
}

}  // namespace
}  // namespace meniscus
