// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/coincident.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace meniscus::reading {
namespace {

TEST(CountCoincident, CountsAllButTheFirstAtEachPlace) {
    EXPECT_EQ(count_coincident({}), 0U);
    EXPECT_EQ(count_coincident({{1, 2, 3}, {3, 2, 1}, {1, 3, 2}}), 0U);
    EXPECT_EQ(count_coincident({{1, 2, 3}, {0, 0, 0}, {1, 2, 3}, {1, 2, 3}, {-0.0, 0, -0.0}}), 3U);
}

// Many points, of which some lie on those before, with the decimals of files.
TEST(CountCoincident, CountsThoseOfManyPoints) {
    std::mt19937 random(1);
    std::uniform_int_distribution<int> thousandths(-99'999, 99'999);
    std::vector<Vec3> points;
    for (int i = 0; i < 20'000; ++i)
        points.push_back({thousandths(random) / 1e3, thousandths(random) / 1e3, thousandths(random) / 1e3});
    EXPECT_LT(likely_coincident(points).size(), points.size() / 5);
    EXPECT_EQ(count_coincident(points), 0U);
    for (std::size_t i = 0; i < 20'000; i += 40) points.push_back(points[i]);
    EXPECT_EQ(count_coincident(points), 500U);
    EXPECT_EQ(count_coincident(std::vector<Vec3>(1000, Vec3{1, 2, 3})), 999U);
}

}  // namespace
}  // namespace meniscus::reading
