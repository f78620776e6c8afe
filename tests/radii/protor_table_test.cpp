// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "set_radius.h"

namespace meniscus::test {
namespace {

TEST(ProtorTable, GivesTheAtomTypesOfTsaiEtAl) {
    EXPECT_EQ(radius_in("protor", {"ALA", "C", "C"}), 1.61);
    EXPECT_EQ(radius_in("protor", {"PHE", "CZ", "C"}), 1.76);
    EXPECT_EQ(radius_in("protor", {"ALA", "CB", "C"}), 1.88);
    EXPECT_EQ(radius_in("protor", {"LYS", "NZ", "N"}), 1.64);
    EXPECT_EQ(radius_in("protor", {"ALA", "O", "O"}), 1.42);
    EXPECT_EQ(radius_in("protor", {"SER", "OG", "O"}), 1.46);
    EXPECT_EQ(radius_in("protor", {"MET", "SD", "S"}), 1.77);
    EXPECT_EQ(radius_in("protor", {"DG", "P", "P"}), 1.80);
    EXPECT_EQ(radius_in("protor", {"MSE", "SE", "SE"}), 1.90);
}

TEST(ProtorTable, KnowsVariantsAndOldNames) {
    EXPECT_EQ(radius_in("protor", {"HSD", "CE1", "C"}), 1.76);
    EXPECT_EQ(radius_in("protor", {"DC", "C5*", "C"}), 1.88);
    EXPECT_EQ(radius_in("protor", {"ILE", "CD", "C"}), 1.88);
}

TEST(ProtorTable, DoesNotKnowHaem) { EXPECT_EQ(radius_in("protor", {"HEM", "CHA", "C"}), -1.0); }

}  // namespace
}  // namespace meniscus::test
