// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/shortest_digits.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

#include "core/bits.h"

namespace meniscus {
namespace {

template <class Number>
std::string by_standard_library(Number value) {
    std::array<char, 400> text{};
    return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}

TEST(ShortestText, IsThatOfTheStandardLibraryForAnyBits) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 200'000; ++i) {
        const std::uint64_t bits = random();
        const auto value = bit_cast<double>(bits);
        const auto small = bit_cast<float>(static_cast<std::uint32_t>(bits));
        if (std::isnan(value) || std::isnan(small)) continue;
        ASSERT_EQ(shortest_text(value), by_standard_library(value));
        ASSERT_EQ(shortest_text(small), by_standard_library(small));
    }
}

TEST(ShortestText, IsThatOfTheStandardLibraryForNumbersOfTheUsualSize) {
    std::mt19937_64 random(8);
    std::uniform_real_distribution<double> exponent(-8.0, 25.0);
    for (int i = 0; i < 200'000; ++i) {
        const double value = std::round(std::pow(10.0, exponent(random))) / std::pow(10.0, i % 7);
        ASSERT_EQ(shortest_text(-value), by_standard_library(-value));
        ASSERT_EQ(shortest_text(static_cast<float>(value)), by_standard_library(static_cast<float>(value)));
    }
}

TEST(ShortestText, KnowsZerosInfinitiesAndPowersOfTen) {
    for (const double value : {0.0, -0.0, 1.0, 100.0, 1e5, 1e22, 1e23, 1e-4, 1e-5, 0.1, 123456.0,
                               std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::denorm_min(), std::numeric_limits<double>::max()})
        EXPECT_EQ(shortest_text(value), by_standard_library(value));
}

}  // namespace
}  // namespace meniscus
