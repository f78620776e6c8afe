// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/structure.h"

namespace meniscus {
namespace {

/// Chains A, B and A again, a residue each; two atoms in the first.
Structure three_residues() {
    Structure s;
    s.name = "three";
    s.atoms = {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {1.5, 1.6, 1.7, 1.8}};
    s.residues = {{.chain = "A", .name = "GLY", .number = 1},
                  {.chain = "B", .name = "ALA", .number = 2, .insertion_code = 'C'},
                  {.chain = "A", .name = "SER", .number = 3}};
    s.labels = {{.residue = 0, .name = "CA", .element = "C"},
                {.residue = 0, .name = "N", .element = "N", .b_factor = 20.0},
                {.residue = 1, .name = "CA", .element = "C", .altloc = 'A'},
                {.residue = 2, .name = "OG", .element = "O"}};
    return s;
}

using Selected = std::vector<bool>;

TEST(SelectAtoms, ByEveryNameThatAtomsHave) {
    const Structure s = three_residues();
    EXPECT_EQ(select_atoms(s, "//A"), (Selected{true, true, false, true}));
    EXPECT_EQ(select_atoms(s, "//A/2-9"), (Selected{false, false, false, true}));
    EXPECT_EQ(select_atoms(s, "(GLY,ALA)"), (Selected{true, true, true, false}));
    EXPECT_EQ(select_atoms(s, "CA"), (Selected{true, false, true, false}));
    EXPECT_EQ(select_atoms(s, ";b>10"), (Selected{false, true, false, false}));
}

TEST(SelectAtoms, NothingAndNonsenseAreUsageErrors) {
    EXPECT_THROW(select_atoms(three_residues(), "//Z"), UsageError);
    EXPECT_THROW(select_atoms(three_residues(), "//A/(("), UsageError);
    try {
        select_atoms(three_residues(), "//Z", "--show");
    } catch (const UsageError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("--show //Z: ")) << error.what();
    }
}

// Of fuzzing: gemmi repeats all that is wrong with a selection.
TEST(SelectAtoms, LongSelectionsAreToldInShortMessages) {
    std::string expression;
    for (int i = 0; i < 500; ++i) expression += ";q<9";
    for (const std::string& wrong : {expression + "?", expression + ";q<-1"}) {
        try {
            select_atoms(three_residues(), wrong);
            FAIL();
        } catch (const UsageError& error) {
            EXPECT_LT(std::string(error.what()).size(), 500U);
        }
    }
}

TEST(SplitChains, InTheOrderOfTheirFirstAtoms) {
    const std::vector<Structure> chains = split_chains(three_residues());
    ASSERT_EQ(chains.size(), 2U);
    EXPECT_EQ(chains[0].atoms.radii, (std::vector<double>{1.5, 1.6, 1.8}));
    EXPECT_EQ(chains[0].residues.size(), 2U);
    EXPECT_EQ(chains[0].labels[2].residue, 1U);
    EXPECT_EQ(chains[0].dropped.at("chains"), 1U);
    EXPECT_EQ(chains[1].residues[chains[1].labels[0].residue].insertion_code, 'C');
    EXPECT_EQ(chains[1].atoms.size(), 1U);
    EXPECT_EQ(chains[1].name, "three");
}

}  // namespace
}  // namespace meniscus
