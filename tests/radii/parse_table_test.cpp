// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "set_radius.h"

namespace meniscus::test {
namespace {

double parse(std::string_view residue, std::string_view name, std::string_view element, bool n_terminal = false) {
    return radius_in("parse", {residue, name, element, n_terminal});
}

TEST(ParseTable, HydrogensOnAliphaticCarbonDoNotExist) {
    EXPECT_EQ(parse("ALA", "HA", "H"), 0.0);
    EXPECT_EQ(parse("LEU", "HD11", "H"), 0.0);
    EXPECT_EQ(parse("THR", "HG21", "H"), 0.0);
    EXPECT_EQ(parse("ALA", "1HB", "H"), 0.0);
}

TEST(ParseTable, PolarAndAromaticHydrogensExist) {
    EXPECT_EQ(parse("ALA", "H", "H"), 1.0);
    EXPECT_EQ(parse("ALA", "HN", "H"), 1.0);
    EXPECT_EQ(parse("THR", "HG1", "H"), 1.0);
    EXPECT_EQ(parse("SER", "HG", "H"), 1.0);
    EXPECT_EQ(parse("PHE", "HZ", "H"), 1.0);
    EXPECT_EQ(parse("HIS", "HD2", "H"), 1.0);
    EXPECT_EQ(parse("ARG", "HH12", "H"), 1.0);
    EXPECT_EQ(parse("HOH", "H1", "H"), 1.0);
}

TEST(ParseTable, ChargedAminoGroupsAreOneBall) {
    EXPECT_EQ(parse("LYS", "NZ", "N"), 2.0);
    EXPECT_EQ(parse("LYS", "HZ1", "H"), 0.0);
    EXPECT_EQ(parse("ALA", "N", "N", true), 2.0);
    EXPECT_EQ(parse("ALA", "H1", "H", true), 0.0);
    EXPECT_EQ(parse("ALA", "N", "N"), 1.5);
    EXPECT_EQ(parse("LYN", "NZ", "N"), 1.5);
    EXPECT_EQ(parse("LYN", "HZ1", "H"), 1.0);
}

TEST(ParseTable, HeavyAtoms) {
    EXPECT_EQ(parse("ALA", "C", "C"), 1.7);
    EXPECT_EQ(parse("ALA", "CB", "C"), 2.0);
    EXPECT_EQ(parse("TYR", "CZ", "C"), 1.7);
    EXPECT_EQ(parse("MET", "SD", "S"), 1.85);
    EXPECT_EQ(parse("GLU", "OE1", "O"), 1.4);
    EXPECT_EQ(parse("CA", "CA", "CA"), -1.0);
}

TEST(ParseTable, Nucleotides) {
    EXPECT_EQ(parse("G", "P", "P"), 1.9);
    EXPECT_EQ(parse("G", "H1", "H"), 1.1);
    EXPECT_EQ(parse("G", "HO2'", "H"), 0.0);
    EXPECT_EQ(parse("DA", "C5'", "C"), 1.7);
}

}  // namespace
}  // namespace meniscus::test
