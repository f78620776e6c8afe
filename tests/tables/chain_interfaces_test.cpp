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
