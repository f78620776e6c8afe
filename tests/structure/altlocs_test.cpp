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

Kept kept(const RawModel& model, const std::string& wanted = "") {
    return choose_altlocs(model, all_atoms(model), wanted).atoms;
}

TEST(Altlocs, HighestSummedOccupancyOfTheResidueWins) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N", "C", "C", "O"});
    set(model, 0, 'A', 0.7);  // A wins here, but B in the sum
    set(model, 1, 'B', 0.3);
    set(model, 2, 'A', 0.1);
    set(model, 3, 'B', 0.9);
    EXPECT_EQ(kept(model), (Kept{1, 3, 4}));
}

TEST(Altlocs, FirstOfTheFileWinsTies) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N"});
    set(model, 0, 'B', 0.5);
    set(model, 1, 'A', 0.5);
    EXPECT_EQ(kept(model), (Kept{0}));
}

TEST(Altlocs, ResiduesOfDifferentNamesAtOneSiteAreAlternatives) {
    RawModel model;
    add_residue(model, "SER", 22, {"N", "C"});
    add_residue(model, "PRO", 22, {"N", "C"});
    set(model, 0, 'A', 0.4);
    set(model, 1, 'A', 0.4);
    set(model, 2, 'B', 0.6);
    set(model, 3, 'B', 0.6);
    EXPECT_EQ(kept(model), (Kept{2, 3}));
    EXPECT_EQ(kept(model, "A"), (Kept{0, 1}));
}

TEST(Altlocs, SitesChooseForThemselves) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N"});
    add_residue(model, "SER", 2, {"N", "N"});
    set(model, 0, 'A', 0.9);
    set(model, 1, 'B', 0.1);
    set(model, 2, 'A', 0.1);
    set(model, 3, 'B', 0.9);
    EXPECT_EQ(kept(model), (Kept{0, 3}));
}

TEST(Altlocs, AWantedLetterThatASiteLacksLeavesItTheBest) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N"});
    set(model, 0, 'A', 0.2);
    set(model, 1, 'B', 0.8);
    EXPECT_EQ(kept(model, "C"), (Kept{1}));
    EXPECT_EQ(kept(model, "A"), (Kept{0}));
}

// A serine with the main chain that is given: CB has A and B, OG has C and D, which occur more often.
RawModel serine(std::initializer_list<const char*> main_chain) {
    RawModel model;
    add_residue(model, "SER", 1, main_chain);
    const std::size_t first = model.atoms.size();
    for (const char* name : {"CB", "CB", "OG", "OG"}) {
        model.atoms.push_back(model.atoms.front());
        model.atoms.back().name = name;
        model.atoms.back().centre = {10.0 * static_cast<double>(model.atoms.size()), 0.0, 0.0};
    }
    set(model, first, 'A', 0.6);
    set(model, first + 1, 'B', 0.4);
    set(model, first + 2, 'C', 0.7);
    set(model, first + 3, 'D', 0.3);
    return model;
}

TEST(Altlocs, AnAtomThatLacksTheLetterTakesItsBest) {
    const RawModel model = serine({"N"});
    EXPECT_EQ(kept(model), (Kept{0, 1, 3}));
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), "").substitutes, 1U);
    EXPECT_EQ(kept(model, "B"), (Kept{0, 2, 3}));
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), "B").substitutes, 1U);
}

TEST(Altlocs, NoMainChainIsLostToTheLetterOfASideChain) {
    RawModel model = serine({"N", "N", "CA", "CA"});
    for (const std::size_t atom : {0U, 2U}) set(model, atom, 'A', 0.1);
    for (const std::size_t atom : {1U, 3U}) set(model, atom, 'B', 0.1);
    EXPECT_EQ(kept(model), (Kept{0, 2, 4, 6}));
}

TEST(Altlocs, OfOtherResiduesAtTheSiteOnlyAMainChainIsTaken) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "CA", "C", "O", "CB", "OG"});
    add_residue(model, "THR", 1, {"CB", "OG1", "CG2"});
    for (std::size_t i = 0; i < 6; ++i) set(model, i, 'A', 0.2);
    for (std::size_t i = 6; i < 9; ++i) set(model, i, 'B', 0.8);
    EXPECT_EQ(kept(model), (Kept{0, 1, 2, 3, 6, 7, 8}));
    for (RawResidue& residue : model.residues) residue.kind = ResidueKind::Ligand;
    EXPECT_EQ(kept(model), (Kept{6, 7, 8}));
}

TEST(Altlocs, HydrogenAndDeuteriumAreOneAtom) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "H", "D", "CB", "HB", "DB"});
    for (const std::size_t atom : {1U, 4U}) set(model, atom, 'A', 0.3);
    for (const std::size_t atom : {2U, 5U}) set(model, atom, 'B', 0.7);
    for (const std::size_t atom : {2U, 5U}) model.atoms[atom].centre = model.atoms[atom - 1].centre + Vec3{0.1, 0, 0};
    EXPECT_EQ(kept(model), (Kept{0, 2, 3, 5}));
    EXPECT_EQ(kept(model, "A"), (Kept{0, 1, 3, 4}));
}

TEST(Altlocs, AnAtomWithAndWithoutALetterIsNotTakenTwice) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "N", "C", "C"});
    set(model, 1, 'A', 0.5);
    set(model, 2, 'B', 0.9);
    set(model, 3, 'A', 0.1);
    EXPECT_EQ(kept(model), (Kept{0, 2}));
}

// As where a program adds a second place of a side chain and leaves the first as it was.
TEST(Altlocs, WithoutALetterBesideOneWithALetterIsAnAlternative) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "CB", "CB", "OG", "OG"});
    set(model, 2, 'B', 0.4);
    set(model, 4, 'B', 0.4);
    EXPECT_EQ(kept(model), (Kept{0, 1, 3}));
    EXPECT_EQ(kept(model, "B"), (Kept{0, 2, 4}));
    EXPECT_EQ(kept(model, "A"), (Kept{0, 1, 3}));
    for (const std::size_t atom : {1U, 3U}) set(model, atom, ' ', 0.3);
    EXPECT_EQ(kept(model), (Kept{0, 2, 4}));
    for (const std::size_t atom : {1U, 3U}) set(model, atom, ' ', 0.4);
    EXPECT_EQ(kept(model), (Kept{0, 1, 3}));
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), "").substitutes, 0U);
}

// One choice for the residue: CB alone would be taken of B, OG alone without a letter.
TEST(Altlocs, WithAndWithoutALetterAreNotMixedInAResidue) {
    RawModel model;
    add_residue(model, "SER", 1, {"CB", "CB", "OG", "OG", "HG"});
    set(model, 0, ' ', 0.4);
    set(model, 1, 'B', 0.6);
    set(model, 2, ' ', 0.9);
    set(model, 3, 'B', 0.1);
    set(model, 4, 'B', 0.1);
    EXPECT_EQ(kept(model), (Kept{0, 2, 4}));
    EXPECT_EQ(choose_altlocs(model, all_atoms(model), "").substitutes, 1U);
}

TEST(Altlocs, NamesakesOfOtherResiduesAreNoAlternatives) {
    RawModel model;
    add_residue(model, "SER", 1, {"CB", "OG"});
    add_residue(model, "SER", 2, {"CB", "CB"});
    set(model, 2, 'A', 0.1);
    set(model, 3, 'B', 0.2);
    EXPECT_EQ(kept(model), (Kept{0, 1, 3}));
}

}  // namespace
}  // namespace meniscus::reading
