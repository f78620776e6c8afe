// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/half_space.h"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

constexpr HalfSpace kBelow{.point = {0, 0, 2}, .normal = {0, 0, 1}};
constexpr double kEndless = std::numeric_limits<double>::infinity();

void expect_part(const Vec3& origin, const Vec3& direction, const Interval& expected) {
    const Interval part = kBelow.part_of_ray(origin, direction);
    EXPECT_EQ(part.begin, expected.begin);
    EXPECT_EQ(part.end, expected.end);
}

TEST(HalfSpace, LiesBehindItsNormal) {
    EXPECT_TRUE(kBelow.contains({7, 7, 2}));
    EXPECT_TRUE(kBelow.contains({0, 0, -9}));
    EXPECT_FALSE(kBelow.contains({0, 0, 2.1}));
    EXPECT_EQ(kBelow.height({1, 1, 5}), 3.0);
}

TEST(HalfSpace, RaysEnterItOrLeaveItOnce) {
    expect_part({0, 0, 5}, {0, 0, -1}, {3.0, kEndless});
    expect_part({0, 0, 5}, {0, 0.8, -0.6}, {5.0, kEndless});
    expect_part({0, 0, 1}, {0, 0, -1}, {0.0, kEndless});
    expect_part({0, 0, 1}, {0, 0, 1}, {0.0, 1.0});
    expect_part({0, 0, 5}, {0, 0, 1}, {0.0, 0.0});
}

TEST(HalfSpace, RaysAlongThePlaneAreInOrOut) {
    expect_part({0, 0, 1}, {1, 0, 0}, {0.0, kEndless});
    expect_part({0, 0, 3}, {1, 0, 0}, {0.0, 0.0});
}

}  // namespace
}  // namespace meniscus
