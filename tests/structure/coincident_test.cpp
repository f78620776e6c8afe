// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/coincident.h"

#include <gtest/gtest.h>

namespace meniscus::reading {
namespace {

TEST(CountCoincident, CountsAllButTheFirstAtEachPlace) {
    EXPECT_EQ(count_coincident({}), 0U);
    EXPECT_EQ(count_coincident({{1, 2, 3}, {3, 2, 1}, {1, 3, 2}}), 0U);
    EXPECT_EQ(count_coincident({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {1, 2, 3}, {-0.0, 0, -0.0}}), 3U);
}

}  // namespace
}  // namespace meniscus::reading
