// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/colours.h"

namespace meniscus {
namespace {

TEST(ColourNames, AreThoseOfCssInAnyCase) {
    EXPECT_EQ(colour_of_text("tomato"), (Colour{255, 99, 71}));
    EXPECT_EQ(colour_of_text("RebeccaPurple"), (Colour{102, 51, 153}));
    EXPECT_EQ(colour_of_text("aliceblue"), (Colour{240, 248, 255}));
    EXPECT_EQ(colour_of_text("yellowgreen"), (Colour{154, 205, 50}));
    EXPECT_EQ(colour_of_text("grey"), colour_of_text("gray"));
}

TEST(ColourNames, AreSixHexadecimalDigitsOtherwise) {
    EXPECT_EQ(colour_of_text("#FF6347"), colour_of_text("tomato"));
    EXPECT_EQ(colour_of_text("#00000a"), (Colour{0, 0, 10}));
    for (const char* text : {"", "#", "#fff", "#ff634", "#ff63477", "#ff634g", "#-f6347", "# f6347", "ff6347", "tomat",
                             "transparent", "chain"})
        EXPECT_FALSE(colour_of_text(text)) << text;
}

}  // namespace
}  // namespace meniscus
