// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/numbers.h"

#include <gtest/gtest.h>

#include <bit>
#include <charconv>
#include <cstdint>
#include <random>
#include <string>
#include <system_error>

namespace meniscus::reading {
namespace {

TEST(Numbers, WholeFiniteNumbersOnly) {
    EXPECT_EQ(finite_number("  11.104"), 11.104);
    EXPECT_EQ(finite_number("-1e-3 "), -1e-3);
    EXPECT_EQ(finite_number("+2"), 2.0);
    EXPECT_EQ(finite_number(".5"), 0.5);
    for (const char* text : {"", "   ", "********", "nan", "NaN", "inf", "-inf", "1e400", "11,104", "1.0x", "1 2",
                             "0x10", "+-1", "--1", "1.2.3"}) {
        EXPECT_FALSE(finite_number(text).has_value()) << text;
    }
}

TEST(Numbers, ShortDecimalsAreTheNearestNumbers) {
    std::mt19937 random(7);
    for (int i = 0; i < 20000; ++i) {
        std::string text(1 + random() % 15, '0');
        for (char& c : text) c = static_cast<char>('0' + random() % 10);
        if (random() % 4 > 0) text[random() % text.size()] = '.';
        if (random() % 2 > 0) text[0] = '-';
        double expected = 0.0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), expected);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        const std::optional<double> value = short_decimal(text);
        ASSERT_EQ(value.has_value(), is_number) << text;
        if (!is_number) continue;
        ASSERT_EQ(std::bit_cast<std::uint64_t>(*value), std::bit_cast<std::uint64_t>(expected)) << text;
    }
    for (const char* text : {"", "-", ".", "-.", "1e3", "+1", "1234567890123456"})
        EXPECT_FALSE(short_decimal(text).has_value()) << text;
}

TEST(Numbers, IntegersOnly) {
    EXPECT_EQ(integer(" -17 "), -17);
    EXPECT_FALSE(integer("1.0").has_value());
    EXPECT_FALSE(integer("99999999999").has_value());
    EXPECT_FALSE(integer("").has_value());
}

}  // namespace
}  // namespace meniscus::reading
