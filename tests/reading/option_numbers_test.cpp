// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/option_numbers.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"

namespace meniscus {

TEST(ParseNumber, ReadsTheWholeText) {
    EXPECT_EQ(parse_number("--probe", "1.4", NumberRange::Positive), 1.4);
    EXPECT_EQ(parse_number("--probe", "0", NumberRange::NotNegative), 0.0);
    EXPECT_EQ(parse_number("--density", "-.5", NumberRange::Negative), -0.5);
    EXPECT_EQ(parse_number("--spacing", "2.5e-1", NumberRange::Positive), 0.25);
}

TEST(ParseNumber, RefusesWhatIsNoFiniteNumberOfTheRightSign) {
    for (const char* text : {"", "abc", "1.4A", "1,4", " 1", "0x10", "1e400", "nan", "inf", "-1", "0"})
        EXPECT_THROW(parse_number("--spacing", text, NumberRange::Positive), UsageError) << text;
    EXPECT_THROW(parse_number("--density", "-inf", NumberRange::Negative), UsageError);
    EXPECT_THROW(parse_number("--density", "0", NumberRange::Negative), UsageError);
}

TEST(ParseNumber, NamesOptionAndValue) {
    try {
        parse_number("--spacing", "-1", NumberRange::Positive);
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "--spacing: must be a finite number greater than 0, not -1");
    }
}

TEST(ParseCount, TakesWholeNumbersFromOne) {
    EXPECT_EQ(parse_count("--threads", "8"), 8);
    for (const char* text : {"", "0", "-1", "1.5", "two", "99999999999"})
        EXPECT_THROW(parse_count("--threads", text), UsageError) << text;
}

TEST(ParseMemory, CountsInMegabytes) {
    EXPECT_EQ(parse_memory("--memory", "500M"), 500u);
    EXPECT_EQ(parse_memory("--memory", "4G"), 4096u);
    EXPECT_EQ(parse_memory("--memory", "0.5GB"), 512u);
    EXPECT_EQ(parse_memory("--memory", "1T"), 1048576u);
    EXPECT_EQ(parse_memory("--memory", "200"), 200u);
}

TEST(ParseMemory, RefusesOtherText) {
    for (const char* text : {"", "G", "0", "0M", "-1G", "4X", "4 G", "0.5M", "1e3M", "99999999999999999999T", "nan"})
        EXPECT_THROW(parse_memory("--memory", text), UsageError) << text;
}

TEST(LooksLikeNegativeNumber, TellsValuesFromOptions) {
    for (const char* text : {"-1", "-.5", "-inf", "-4e-2"}) EXPECT_TRUE(looks_like_negative_number(text)) << text;
    for (const char* text : {"-o", "--probe", "-", "1", ""}) EXPECT_FALSE(looks_like_negative_number(text)) << text;
}

}  // namespace meniscus
