// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/numbers.h"

#include <gtest/gtest.h>

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

TEST(Numbers, IntegersOnly) {
    EXPECT_EQ(integer(" -17 "), -17);
    EXPECT_FALSE(integer("1.0").has_value());
    EXPECT_FALSE(integer("99999999999").has_value());
    EXPECT_FALSE(integer("").has_value());
}

}  // namespace
}  // namespace meniscus::reading
