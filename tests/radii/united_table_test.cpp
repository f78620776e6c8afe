// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "set_radius.h"

namespace meniscus::test {
namespace {

double united(std::string_view residue, std::string_view name, std::string_view element) {
    return radius_in("united", {residue, name, element});
}

TEST(UnitedTable, Oxygens) {
    EXPECT_EQ(united("GLY", "O", "O"), 1.40);
    EXPECT_EQ(united("ASP", "OD2", "O"), 1.40);
    EXPECT_EQ(united("GLY", "OXT", "O"), 1.40);
    EXPECT_EQ(united("SER", "OG", "O"), 1.60);
    EXPECT_EQ(united("THR", "OG1", "O"), 1.60);
    EXPECT_EQ(united("TYR", "OH", "O"), 1.60);
    EXPECT_EQ(united("HOH", "O", "O"), 1.60);
    EXPECT_EQ(united("TIP3", "OH2", "O"), 1.60);
    EXPECT_EQ(united("DA", "OP1", "O"), 1.40);
}

TEST(UnitedTable, Nitrogens) {
    EXPECT_EQ(united("PRO", "N", "N"), 1.70);
    EXPECT_EQ(united("ARG", "NE", "N"), 1.70);
    EXPECT_EQ(united("ARG", "NH1", "N"), 1.80);
    EXPECT_EQ(united("ASN", "ND2", "N"), 1.80);
    EXPECT_EQ(united("GLN", "NE2", "N"), 1.80);
    EXPECT_EQ(united("LYS", "NZ", "N"), 2.00);
    EXPECT_EQ(united("HEM", "NA", "N"), 1.54);
}

TEST(UnitedTable, TheNitrogenOfHistidineWithoutHydrogenIsSmaller) {
    EXPECT_EQ(united("HIS", "ND1", "N"), 1.54);
    EXPECT_EQ(united("HIS", "NE2", "N"), 1.70);
    EXPECT_EQ(united("HIE", "ND1", "N"), 1.54);
    EXPECT_EQ(united("HID", "ND1", "N"), 1.70);
    EXPECT_EQ(united("HSD", "NE2", "N"), 1.54);
    EXPECT_EQ(united("HIP", "ND1", "N"), 1.70);
}

TEST(UnitedTable, Carbons) {
    EXPECT_EQ(united("GLY", "C", "C"), 1.74);
    EXPECT_EQ(united("LEU", "CG", "C"), 1.74);
    EXPECT_EQ(united("GLU", "CD", "C"), 1.74);
    EXPECT_EQ(united("ARG", "CZ", "C"), 1.74);
    EXPECT_EQ(united("TRP", "CE2", "C"), 1.74);
    EXPECT_EQ(united("PHE", "CZ", "C"), 1.86);
    EXPECT_EQ(united("TYR", "CZ", "C"), 1.74);
    EXPECT_EQ(united("HIS", "CE1", "C"), 1.86);
    EXPECT_EQ(united("HSE", "CD2", "C"), 1.86);
    EXPECT_EQ(united("GLY", "CA", "C"), 2.00);
    EXPECT_EQ(united("LYS", "CD", "C"), 2.00);
    EXPECT_EQ(united("DA", "C5'", "C"), 2.00);
}

TEST(UnitedTable, SulphurWithHydrogenIsLarger) {
    EXPECT_EQ(united("CYS", "SG", "S"), 1.85);
    EXPECT_EQ(united("CYX", "SG", "S"), 1.80);
    EXPECT_EQ(united("MET", "SD", "S"), 1.80);
    EXPECT_EQ(united("DA", "P", "P"), 1.80);
}

TEST(UnitedTable, MetalsAndSelenium) {
    EXPECT_EQ(united("HEM", "FE", "FE"), 1.30);
    EXPECT_EQ(united("SF4", "FE1", "FE"), 1.30);
    EXPECT_EQ(united("FE", "FE", "FE"), 1.24);
    EXPECT_EQ(united("CA", "CA", "CA"), 1.97);
    EXPECT_EQ(united("ZN", "ZN", "ZN"), 1.40);
    EXPECT_EQ(united("MSE", "SE", "SE"), 2.15);
    EXPECT_EQ(united("XE", "XE", "XE"), -1.0);
}

}  // namespace
}  // namespace meniscus::test
