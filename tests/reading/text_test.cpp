// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/text.h"

#include <gtest/gtest.h>

namespace meniscus::reading {
namespace {

TEST(Text, LinesKnowTheirNumbersAndOffsets) {
    Lines lines("one\n\nthree");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "one");
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "");
    EXPECT_EQ(lines.begin(), 4U);
    EXPECT_EQ(lines.end(), 5U);
    ASSERT_TRUE(lines.next());
    EXPECT_EQ(lines.line(), "three");
    EXPECT_EQ(lines.number(), 3U);
    EXPECT_FALSE(lines.next());
    EXPECT_FALSE(Lines("").next());
}

TEST(Text, WordsKnowTheirColumns) {
    Words words("  a\tbc ");
    EXPECT_EQ(words.next(), "a");
    EXPECT_EQ(words.column(), 3U);
    EXPECT_EQ(words.next(), "bc");
    EXPECT_EQ(words.column(), 5U);
    EXPECT_EQ(words.next(), "");
    EXPECT_EQ(words.column(), 8U);
}

TEST(Text, AllLineEndsBecomeOneAndTheByteOrderMarkGoes) {
    std::string text =
        "\xEF\xBB\xBF"
        "a\r\nb\rc\n\r\n";
    normalise_line_ends(text);
    EXPECT_EQ(text, "a\nb\nc\n\n");
}

TEST(Text, WordsInMessagesAreShortAndPrintable) {
    EXPECT_EQ(shown("a\x01"
                    "b"),
              "'a?b'");
    EXPECT_EQ(shown(std::string(100, 'x')).size(), 45U);
}

TEST(Text, ErrorsHaveFileLineAndColumn) {
    try {
        fail_at("f.pdb", {3, 7}, "what; do");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "f.pdb:3:7: what; do");
    }
}

}  // namespace
}  // namespace meniscus::reading
