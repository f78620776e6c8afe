// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "simd/pairs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <random>

namespace meniscus {
namespace {

constexpr double kPi = std::numbers::pi;

double arc_tangent_of(double y, double x) { return arc_tangent(Pair{y, 1.0}, Pair{x, 1.0})[0]; }

TEST(Pairs, ArcTangentsAreThoseOfTheStandardLibrary) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    std::uniform_real_distribution<double> digits(-12.0, 0.0);
    for (int i = 0; i < 100'000; ++i) {
        const double y = within(random) * std::pow(10.0, i % 3 == 0 ? digits(random) : 0.0);
        const double x = within(random) * std::pow(10.0, i % 5 == 0 ? digits(random) : 0.0);
        const double expected = std::atan2(y, x);
        EXPECT_NEAR(arc_tangent_of(y, x), expected, 3.0 * std::numeric_limits<double>::epsilon() * std::abs(expected))
            << y << ' ' << x;
    }
}

TEST(Pairs, ArcTangentsOfAxes) {
    EXPECT_EQ(arc_tangent_of(0.0, 2.0), 0.0);
    EXPECT_EQ(arc_tangent_of(2.0, 0.0), 0.5 * kPi);
    EXPECT_EQ(arc_tangent_of(0.0, -2.0), kPi);
    EXPECT_EQ(arc_tangent_of(-0.0, -2.0), kPi) << "zeros have no sign";
    EXPECT_EQ(arc_tangent_of(-2.0, 0.0), -0.5 * kPi);
    EXPECT_EQ(arc_tangent_of(0.0, 0.0), 0.0);
}

TEST(Pairs, VectorsSideBySideHaveTheBitsThatTheyHaveAlone) {
    const Vec3 a{1.1, -2.3, 0.7};
    const Vec3 b{-0.4, 0.9, 3.1};
    const Vec3 c{0.3, 1.7, -2.2};
    const Pair3 crossed = cross(both(a, b), both(b, c));
    EXPECT_EQ(crossed[0], cross(a, b));
    EXPECT_EQ(crossed[1], cross(b, c));
    EXPECT_EQ(norm(both(a, b))[1], norm(b));
    EXPECT_EQ(dot(both(a, b), both(b, c))[0], dot(a, b));
}

}  // namespace
}  // namespace meniscus
