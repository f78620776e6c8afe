// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "set_radius.h"

namespace meniscus::test {
namespace {

TEST(NaccessTable, GivesItsAtomTypes) {
    EXPECT_EQ(radius_in("naccess", {"ALA", "CB", "C"}), 1.87);
    EXPECT_EQ(radius_in("naccess", {"ALA", "C", "C"}), 1.76);
    EXPECT_EQ(radius_in("naccess", {"ALA", "N", "N"}), 1.65);
    EXPECT_EQ(radius_in("naccess", {"LYS", "NZ", "N"}), 1.50);
    EXPECT_EQ(radius_in("naccess", {"CYS", "SG", "S"}), 1.85);
    EXPECT_EQ(radius_in("naccess", {"DA", "P", "P"}), 1.90);
    EXPECT_EQ(radius_in("naccess", {"DA", "N9", "N"}), 1.60);
    EXPECT_EQ(radius_in("naccess", {"U", "O4", "O"}), 1.40);
}

TEST(NaccessTable, ModifiedResiduesHaveTheMainChain) {
    EXPECT_EQ(radius_in("naccess", {"SEP", "CA", "C"}), 1.87);
    EXPECT_EQ(radius_in("naccess", {"SEP", "O", "O"}), 1.40);
}

TEST(NaccessTable, CalciumIsNoAlphaCarbon) { EXPECT_EQ(radius_in("naccess", {"CA", "CA", "CA"}), -1.0); }

}  // namespace
}  // namespace meniscus::test
