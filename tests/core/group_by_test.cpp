// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/group_by.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

namespace meniscus {
namespace {

std::vector<std::uint32_t> members(const Groups& groups, std::size_t group) {
    return {groups[group].begin(), groups[group].end()};
}

TEST(GroupBy, KeepsTheOrderOfGroupsAndOfTheirMembers) {
    const Groups groups = group_by<std::hash<int>>(std::vector<int>{7, 7, -1, 7, 3, 3, -1});
    ASSERT_EQ(groups.size(), 3U);
    EXPECT_EQ(members(groups, 0), (std::vector<std::uint32_t>{0, 1, 3}));
    EXPECT_EQ(members(groups, 1), (std::vector<std::uint32_t>{2, 6}));
    EXPECT_EQ(members(groups, 2), (std::vector<std::uint32_t>{4, 5}));
}

TEST(GroupBy, OfNothing) { EXPECT_EQ(group_by<std::hash<int>>(std::vector<int>{}).size(), 0U); }

}  // namespace
}  // namespace meniscus
