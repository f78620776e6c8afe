// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/altlocs.h"

#include <gtest/gtest.h>

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::add_residue;
using meniscus::testing::all_atoms;

void set(RawModel& model, std::size_t atom, char altloc, double occupancy) {
    model.atoms[atom].altloc = altloc;
    model.atoms[atom].occupancy = occupancy;
}

using Kept = std::vector<std::uint32_t>;

TEST(Altlocs, HighestSummedOccupancyOfTheResidueWins) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N", "C", "C", "O"});
    set(model, 0, 'A', 0.7);  // A wins here, but B in the sum
    set(model, 1, 'B', 0.3);
    set(model, 2, 'A', 0.1);
    set(model, 3, 'B', 0.9);
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), ""), (Kept{1, 3, 4}));
}

TEST(Altlocs, FirstOfTheFileWinsTies) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N"});
    set(model, 0, 'B', 0.5);
    set(model, 1, 'A', 0.5);
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), ""), (Kept{0}));
}

TEST(Altlocs, ResiduesOfDifferentNamesAtOneSiteAreAlternatives) {
    RawModel model;
    add_residue(model, "SER", 22, {"N", "C"});
    add_residue(model, "PRO", 22, {"N", "C"});
    set(model, 0, 'A', 0.4);
    set(model, 1, 'A', 0.4);
    set(model, 2, 'B', 0.6);
    set(model, 3, 'B', 0.6);
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), ""), (Kept{2, 3}));
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), "A"), (Kept{0, 1}));
}

TEST(Altlocs, SitesChooseForThemselves) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N"});
    add_residue(model, "SER", 2, {"N", "N"});
    set(model, 0, 'A', 0.9);
    set(model, 1, 'B', 0.1);
    set(model, 2, 'A', 0.1);
    set(model, 3, 'B', 0.9);
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), ""), (Kept{0, 3}));
}

TEST(Altlocs, AWantedLetterThatASiteLacksLeavesItTheBest) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N"});
    set(model, 0, 'A', 0.2);
    set(model, 1, 'B', 0.8);
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), "C"), (Kept{1}));
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), "A"), (Kept{0}));
}

}  // namespace
}  // namespace meniscus::reading
