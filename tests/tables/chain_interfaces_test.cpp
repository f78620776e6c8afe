// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "small_complex.h"

namespace meniscus {
namespace {

using testing::small_complex;

TEST(ChainInterfaces, OnlyChainsThatTouchArePaired) {
    const auto pairs = touching_chains(small_complex(), 1.4);
    ASSERT_EQ(pairs.size(), 1u);
    EXPECT_EQ(pairs[0].a, (std::vector<std::string>{"A"}));
    EXPECT_EQ(pairs[0].b, (std::vector<std::string>{"B"}));
    EXPECT_TRUE(touching_chains(small_complex(), 0.0).empty());
}

TEST(ChainInterfaces, AreThoseOfTheirAtoms) {
    const Structure s = small_complex();
    const std::vector<ChainPair> pairs{{{"A"}, {"B"}}, {{"LONG", "A"}, {"B"}}};
    const auto found = chain_interfaces(s, pairs);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].group_a, (AtomGroup{0, 1, 2, 3}));
    EXPECT_EQ(found[1].group_a, (AtomGroup{0, 1, 2, 3, 5}));
    EXPECT_EQ(found[0].group_b, (AtomGroup{4}));
    EXPECT_EQ(found[0].areas.sas_ab, measure_interface(s.atoms, {0, 1, 2, 3}, {4}).sas_ab);
    EXPECT_GT(found[0].areas.buried_sas(), 1.0);
    EXPECT_NEAR(found[1].areas.buried_sas(), found[0].areas.buried_sas(), 1e-5);  // the far chain loses nothing
}

TEST(ChainInterfaces, ALigandIsNoPartOfItsChainThen) {
    const Structure s = small_complex();
    const std::vector<ChainPair> pairs{
        {{"A"}, {"(MSE)"}}, {{"A(ALA)"}, {"(MSE,GLY)"}}, {{"A", "B"}, {"(HIE)"}}, {{"(MSE)", "B"}, {"A"}}};
    const auto found = chain_interfaces(s, pairs);
    EXPECT_EQ(found[0].group_a, (AtomGroup{0, 1}));
    EXPECT_EQ(found[0].group_b, (AtomGroup{2, 3}));
    EXPECT_EQ(found[0].areas.sas_ab, measure_interface(s.atoms, {0, 1}, {2, 3}).sas_ab);
    EXPECT_EQ(found[1].group_a, (AtomGroup{0, 1}));
    EXPECT_EQ(found[1].group_b, (AtomGroup{2, 3, 4}));
    EXPECT_EQ(found[2].group_b, (AtomGroup{5}));
    EXPECT_EQ(found[3].group_a, (AtomGroup{2, 3, 4}));
    EXPECT_EQ(found[3].group_b, (AtomGroup{0, 1}));
}

TEST(ChainInterfaces, SayHowALigandIsKept) {
    Structure s = small_complex();
    s.left_out_ligands["HEP"] = 1;
    const auto message_of = [&](const ChainPair& pair) -> std::string {
        try {
            chain_interfaces(s, std::vector<ChainPair>{pair});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message_of({{"A"}, {"(HEP)"}}),
              "HEP was left out with the other ligands; keep them with hetero = ligands");
    EXPECT_EQ(message_of({{"A"}, {"(ZN)"}}),
              "there is no residue (ZN) among the kept atoms; ligands are kept with hetero = ligands, ions, too, with "
              "hetero = all");
    EXPECT_EQ(
        message_of({{"A"}, {"HEP"}}),
        "there is no chain 'HEP' among the kept atoms; there are A, B, LONG; the residues of that name are (HEP)");
    EXPECT_EQ(message_of({{"B"}, {"(GLY)"}}), "the ligands of the other side are all that there is of 'B'");
    EXPECT_EQ(message_of({{"(GLY)"}, {"B(GLY)"}}), "'(GLY)' and 'B(GLY)' have atoms in common");
    EXPECT_EQ(message_of({{"A"}, {"()"}}), "'()' lacks the name of a residue; write for instance (HEM)");
}

TEST(ChainInterfaces, SayWhereChainsHaveNoNames) {
    Structure s = small_complex();
    const auto message_of = [&]() -> std::string {
        try {
            chain_interfaces(s, std::vector<ChainPair>{{{"X"}, {"B"}}});
        } catch (const UsageError& error) {
            return error.what();
        }
        return "";
    };
    s.residues.front().chain = "";
    EXPECT_TRUE(message_of().ends_with("; there are A, B, LONG and one without a name")) << message_of();
    for (Residue& residue : s.residues) residue.chain = "";
    EXPECT_EQ(
        message_of(),
        "there is no chain 'X' among the kept atoms, whose chains have no names; give a file that names them, such "
        "as PDB or mmCIF");
}

TEST(ChainInterfaces, RefuseUnknownChainsAndChainsOnBothSides) {
    const Structure s = small_complex();
    const auto of = [&](const ChainPair& pair) { return chain_interfaces(s, std::vector<ChainPair>{pair}); };
    EXPECT_THROW(of({{"A"}, {"C"}}), UsageError);
    EXPECT_THROW(of({{"A"}, {"B", "A"}}), UsageError);
    try {
        of({{"X"}, {"B"}});
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "there is no chain 'X' among the kept atoms; there are A, B, LONG");
    }
}

}  // namespace
}  // namespace meniscus
