// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/tables.h"

namespace meniscus {
namespace {

TEST(HistoryTable, HasARowPerStep) {
    const FlowStep start{.area = 10.0, .components = 2};
    const FlowStep step{.step = 1, .time = 0.5, .area = 9.0, .solver_iterations = 12, .components = 1, .genus = 3};
    const Table table = history_table(std::vector{start, step});
    ASSERT_EQ(table.rows.size(), 2U);
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
    EXPECT_EQ(table.columns.front(), "step");
    EXPECT_EQ(table.columns.back(), "genus");
    EXPECT_EQ(std::get<std::int64_t>(table.rows[1].front()), 1);
    EXPECT_EQ(std::get<double>(table.rows[1][2]), 9.0);
    EXPECT_EQ(std::get<std::int64_t>(table.rows[1].back()), 3);
}

}  // namespace
}  // namespace meniscus
