// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/elementary.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <limits>
#include <numbers>
#include <random>

namespace meniscus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// How far a result is from the exact value, in units of the last place of that value.
double units_off(double result, long double exact) {
    const int exponent = std::max(std::ilogb(exact), -1022);
    return static_cast<double>(std::abs(result - exact) / std::ldexp(1.0L, exponent - 52));
}

class Elementary : public ::testing::Test {
protected:
    void SetUp() override {
        if (std::numeric_limits<long double>::digits < 64) GTEST_SKIP() << "long double is not wider than double here";
    }

    // The largest error of `count` calls; `error` makes each from a generator of random numbers.
    static double worst(const std::function<double(std::mt19937_64&)>& error, int count = 300'000) {
        std::mt19937_64 random(1);
        double worst = 0.0;
        for (int i = 0; i < count; ++i) worst = std::max(worst, error(random));
        return worst;
    }

    static double between(double low, double high, std::mt19937_64& random) {
        return std::uniform_real_distribution(low, high)(random);
    }

    // A number whose logarithm is evenly distributed.
    static double of_any_size(double low, double high, std::mt19937_64& random) {
        return std::exp(between(std::log(low), std::log(high), random));
    }
};

TEST_F(Elementary, SinesAndCosines) {
    for (const double range : {1e-6, 1.0, 7.0, 1e3, 1e5}) {
        EXPECT_LT(worst([&](auto& random) {
                      const double x = between(-range, range, random);
                      return std::max(units_off(elementary::sin(x), std::sin(static_cast<long double>(x))),
                                      units_off(elementary::cos(x), std::cos(static_cast<long double>(x))));
                  }),
                  1.0)
            << range;
    }
}

// Next to multiples of π/2 a sine or cosine is what the last digits of π leave.
TEST_F(Elementary, SinesAndCosinesNextToTheirZeros) {
    for (int k = -60'000; k <= 60'000; k += 7) {
        const double x = k * (0.5 * std::numbers::pi);
        ASSERT_LT(units_off(elementary::sin(x), std::sin(static_cast<long double>(x))), 1.0) << k;
        ASSERT_LT(units_off(elementary::cos(x), std::cos(static_cast<long double>(x))), 1.0) << k;
    }
}

TEST_F(Elementary, AnglesOfPoints) {
    for (const double range : {1e-3, 1e-1, 1.0, 10.0, 1e3, 1e100}) {
        EXPECT_LT(worst([&](auto& random) {
                      const double x = between(-1.0, 1.0, random);
                      const double y = between(-range, range, random);
                      return units_off(elementary::atan2(y, x),
                                       std::atan2(static_cast<long double>(y), static_cast<long double>(x)));
                  }),
                  1.0)
            << range;
    }
}

TEST_F(Elementary, AnglesOfCosines) {
    EXPECT_LT(worst([](auto& random) {
                  const double x = between(-1.0, 1.0, random);
                  return units_off(elementary::acos(x), std::acos(static_cast<long double>(x)));
              }),
              1.0);
    EXPECT_LT(worst([](auto& random) {
                  const double x = 1.0 - of_any_size(1e-16, 1.0, random);
                  const long double wide = x;
                  return std::max(x < 1.0 ? units_off(elementary::acos(x), std::acos(wide)) : 0.0,
                                  units_off(elementary::acos(-x), std::acos(-wide)));
              }),
              1.0);
}

TEST_F(Elementary, Exponentials) {
    for (const double range : {1e-9, 1e-2, 1.0, 50.0, 700.0}) {
        EXPECT_LT(worst([&](auto& random) {
                      const double x = between(-range, range, random);
                      return units_off(elementary::exp(x), std::exp(static_cast<long double>(x)));
                  }),
                  1.0)
            << range;
    }
    EXPECT_LE(worst([](auto& random) {
                  const double x = between(-745.0, -708.0, random);  // subnormal results
                  return units_off(elementary::exp(x), std::exp(static_cast<long double>(x)));
              }),
              1.0);
}

TEST_F(Elementary, Logarithms) {
    const auto error = [](double x) { return units_off(elementary::log(x), std::log(static_cast<long double>(x))); };
    EXPECT_LT(worst([&](auto& random) { return error(of_any_size(1e-310, 1e308, random)); }), 1.0);
    EXPECT_LT(worst([&](auto& random) { return error(between(0.5, 2.0, random)); }), 1.0);
    EXPECT_LT(worst([&](auto& random) { return error(1.0 + of_any_size(1e-15, 0.5, random)); }), 1.0);
}

TEST(ElementaryEnds, AreExact) {
    EXPECT_EQ(elementary::sin(0.0), 0.0);
    EXPECT_EQ(elementary::cos(0.0), 1.0);
    EXPECT_EQ(elementary::acos(1.0), 0.0);
    EXPECT_EQ(elementary::acos(2.0), 0.0);
    EXPECT_EQ(elementary::acos(-1.0), std::numbers::pi);
    EXPECT_EQ(elementary::acos(-1.5), std::numbers::pi);
    EXPECT_EQ(elementary::acos(0.0), 0.5 * std::numbers::pi);
    EXPECT_EQ(elementary::atan2(0.0, 0.0), 0.0);
    EXPECT_EQ(elementary::atan2(0.0, 3.0), 0.0);
    EXPECT_EQ(elementary::atan2(0.0, -3.0), std::numbers::pi);
    EXPECT_EQ(elementary::atan2(3.0, 0.0), 0.5 * std::numbers::pi);
    EXPECT_EQ(elementary::atan2(-3.0, 0.0), -0.5 * std::numbers::pi);
    EXPECT_EQ(elementary::atan2(2.0, 2.0), 0.25 * std::numbers::pi);
    EXPECT_EQ(elementary::exp(0.0), 1.0);
    EXPECT_EQ(elementary::exp(-800.0), 0.0);
    EXPECT_EQ(elementary::exp(800.0), kInfinity);
    EXPECT_EQ(elementary::log(1.0), 0.0);
    EXPECT_EQ(elementary::log(0.0), -kInfinity);
}

// Another compiler, C library or set of instructions must give these bits, too.
TEST(ElementaryBits, AreTheSameEverywhere) {
    std::uint64_t sum = 0;
    const auto add = [&sum](double value) {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof(bits));
        sum = sum * 0x100000001b3 + bits;
    };
    for (int i = 1; i <= 1000; ++i) {
        const double x = 0.01 * i;
        add(elementary::sin(x));
        add(elementary::cos(x));
        add(elementary::acos(0.2 * x - 1.0));
        add(elementary::exp(x - 5.0));
        add(elementary::log(x));
        add(elementary::atan2(x, 5.0 - x));
    }
    EXPECT_EQ(sum, 1026771080660545426U);
}

}  // namespace
}  // namespace meniscus
