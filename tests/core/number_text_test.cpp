// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/number_text.h"

#include <gtest/gtest.h>

#include <clocale>
#include <limits>

namespace meniscus {
namespace {

TEST(NumberText, IsShort) {
    EXPECT_EQ(in_short(0.25), "0.25");
    EXPECT_EQ(in_short(-3.0), "-3");
    EXPECT_EQ(in_short(1234567.0), "1.23457e+06");
    EXPECT_EQ(in_short(0.123456, 3), "0.123");
    EXPECT_EQ(in_short(std::numeric_limits<double>::infinity()), "inf");
    EXPECT_EQ(in_short(std::numeric_limits<double>::quiet_NaN()), "nan");
}

TEST(NumberText, HasTheDecimalsThatAreAskedFor) {
    EXPECT_EQ(with_decimals(12.5, 2), "12.50");
    EXPECT_EQ(with_decimals(1e300, 0).size(), 301U);
    EXPECT_EQ(with_decimals(-0.5, 0), "-0");
}

TEST(NumberText, IsTheSameInEveryLocale) {
    for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"}) {
        if (std::setlocale(LC_NUMERIC, name) == nullptr) continue;
        EXPECT_EQ(in_short(-1.5e-7), "-1.5e-07") << name;
        EXPECT_EQ(with_decimals(1.5, 1), "1.5") << name;
    }
    std::setlocale(LC_NUMERIC, "C");
}

}  // namespace
}  // namespace meniscus
