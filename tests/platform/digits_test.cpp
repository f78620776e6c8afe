// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/digits.h"

#include <gtest/gtest.h>

#include <charconv>
#include <cmath>
#include <vector>

namespace meniscus {
namespace {

// Those with few decimals are made another way.
TEST(Digits, AreThoseOfToChars) {
    std::vector<double> numbers{0.0, -0.0, 1e-3, 9.999e-3, 99999.999, 1e5, 1e20, 0.1 + 0.2, 1e300 * 1e300};
    for (int k = 1; k < 20'000; ++k) numbers.push_back(k / 1000.0);
    for (int k = 19; k < 110'000'000; k += 9'973) numbers.push_back(-k / 1000.0);
    for (const double x : std::vector<double>(numbers)) numbers.push_back(std::nextafter(x, 1.0));
    for (const double x : numbers) {
        Digits digits;
        Digits expected;
        const auto* const end = std::to_chars(expected.data(), expected.data() + expected.size(), x).ptr;
        ASSERT_EQ(digits_of(x, digits), std::string_view(expected.data(), end));
    }
}

TEST(Digits, EveryTypeHasItsOwn) {
    Digits digits;
    EXPECT_EQ(digits_of(0.1F, digits), "0.1");
    EXPECT_EQ(digits_of(double{0.1F}, digits), "0.10000000149011612");
    EXPECT_EQ(digits_of(std::uint64_t{18446744073709551615U}, digits), "18446744073709551615");
    EXPECT_EQ(digits_of(std::int64_t{-9223372036854775807}, digits), "-9223372036854775807");
}

}  // namespace
}  // namespace meniscus
