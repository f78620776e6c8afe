// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/coincident.h"

#include <gtest/gtest.h>

#include <vector>

namespace meniscus::reading {
namespace {

using Points = std::vector<Vec3>;

TEST(CountCoincident, CountsAllButTheFirstAtEachPlace) {
    EXPECT_EQ(count_coincident(Points{}), 0U);
    EXPECT_EQ(count_coincident(Points{{1, 2, 3}, {3, 2, 1}, {1, 3, 2}}), 0U);
    EXPECT_EQ(count_coincident(Points{{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {1, 2, 3}, {-0.0, 0, -0.0}}), 3U);
}

TEST(CountCoincident, ZeroHasNoSign) { EXPECT_EQ(count_coincident(Points{{0, 0, 0}, {-0.0, 0, -0.0}}), 1U); }

}  // namespace
}  // namespace meniscus::reading
