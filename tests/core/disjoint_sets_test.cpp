// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/disjoint_sets.h"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

TEST(DisjointSets, StartApartAndAreNumberedByTheirSmallestMembers) {
    DisjointSets sets(5);
    EXPECT_TRUE(sets.join(4, 1));
    EXPECT_TRUE(sets.join(3, 4));
    EXPECT_FALSE(sets.join(1, 3));
    EXPECT_EQ(sets.root(4), 1U);
    EXPECT_EQ(sets.numbers(), (std::vector<std::uint32_t>{0, 1, 2, 1, 1}));
    EXPECT_EQ(set_count(sets.numbers()), 3U);
}

TEST(DisjointSets, GrowKeepsWhatIsJoined) {
    DisjointSets sets(2);
    sets.join(0, 1);
    sets.grow(3);
    EXPECT_EQ(sets.numbers(), (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(DisjointSets, NoneHaveNoNumbers) { EXPECT_EQ(set_count(DisjointSets().numbers()), 0U); }

}  // namespace
}  // namespace meniscus
