// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "set_radius.h"

namespace meniscus::test {
namespace {

TEST(BondiTable, GivesTheValuesOf1964) {
    EXPECT_EQ(radius_in("bondi", {"ALA", "CA", "C"}), 1.70);
    EXPECT_EQ(radius_in("bondi", {"ALA", "N", "N"}), 1.55);
    EXPECT_EQ(radius_in("bondi", {"ALA", "O", "O"}), 1.52);
    EXPECT_EQ(radius_in("bondi", {"CYS", "SG", "S"}), 1.80);
    EXPECT_EQ(radius_in("bondi", {"DA", "P", "P"}), 1.80);
    EXPECT_EQ(radius_in("bondi", {"ALA", "HA", "H"}), 1.20);
    EXPECT_EQ(radius_in("bondi", {"ALA", "DA", "D"}), 1.20);
}

TEST(BondiTable, DoesNotKnowIron) { EXPECT_EQ(radius_in("bondi", {"HEM", "FE", "FE"}), -1.0); }

}  // namespace
}  // namespace meniscus::test
