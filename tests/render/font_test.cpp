// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/font.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace meniscus {
namespace {

constexpr Colour kBlack{0, 0, 0, 255};
constexpr std::size_t kWidth = 60;

Picture blank(const Colour& colour = kWhite) { return {60, 30, std::vector<Colour>(30 * kWidth, colour)}; }

std::size_t touched(const Picture& picture, const Colour& background = kWhite) {
    return picture.pixels.size() -
           static_cast<std::size_t>(std::count(picture.pixels.begin(), picture.pixels.end(), background));
}

TEST(Font, ReadsUtf8) {
    EXPECT_EQ(characters_of("aÅ−𝄞"), U"aÅ−𝄞");
    EXPECT_EQ(characters_of(""), U"");
}

TEST(Font, WhatIsNoCharacterIsReplaced) {
    EXPECT_EQ(characters_of("a\xFFz"), U"a\uFFFDz");
    EXPECT_EQ(characters_of("\xC3"), U"\uFFFD") << "cut off";
    EXPECT_EQ(characters_of("\xC0\x80"), U"\uFFFD\uFFFD") << "overlong";
    EXPECT_EQ(characters_of("\xED\xA0\x80"), U"\uFFFD\uFFFD\uFFFD") << "surrogate";
    EXPECT_EQ(characters_of("\xF4\x90\x80\x80").front(), U'\uFFFD') << "beyond Unicode";
    EXPECT_EQ(characters_of("a\tb\n"), U"a\uFFFDb\uFFFD");
}

TEST(Font, WidthsAddUpAndScale) {
    const Font font(20.0);
    EXPECT_NEAR(font.width("Chain A"), font.width("Chain") + font.width(" A"), 1e-9);
    EXPECT_NEAR(Font(40.0).width("Chain A"), 2.0 * font.width("Chain A"), 0.1);
    EXPECT_EQ(font.width(""), 0.0);
    EXPECT_GT(font.width("W"), font.width("i"));
}

TEST(Font, LongTextsEndInAnEllipsis) {
    const Font font(20.0);
    EXPECT_EQ(font.fitted("short", 1000.0), "short");
    const std::string cut = font.fitted("Åååååååååååå", 80.0);
    EXPECT_TRUE(cut.ends_with("…"));
    EXPECT_EQ(characters_of(cut).find(U'\uFFFD'), std::u32string::npos) << "characters stay whole";
    EXPECT_LE(font.width(cut), 80.0);
    EXPECT_EQ(font.fitted("abc", 0.0), "…");
}

TEST(Font, DrawsDarkLettersAboveTheBaseline) {
    Picture picture = blank();
    Font(20.0).draw(picture, {5.0, 20.0}, "H", kBlack);
    EXPECT_GT(touched(picture), 30U);
    EXPECT_NE(std::find(picture.pixels.begin(), picture.pixels.end(), kBlack), picture.pixels.end());
    const auto first = std::find_if(picture.pixels.begin(), picture.pixels.end(), [](auto& c) { return c != kWhite; });
    EXPECT_NEAR(static_cast<double>(first - picture.pixels.begin()) / 60.0, 20.0 - 0.73 * 20.0, 1.5);
    for (std::size_t i = 20 * kWidth; i < picture.pixels.size(); ++i) EXPECT_EQ(picture.pixels[i], kWhite);
}

TEST(Font, CharactersThatTheFontLacksAreSeen) {
    Picture picture = blank();
    Font(20.0).draw(picture, {5.0, 20.0}, "漢", kBlack);
    EXPECT_GT(touched(picture), 20U);
}

TEST(Font, WhatIsOutsideThePictureIsLeftOut) {
    Picture picture = blank();
    const Font font(20.0);
    font.draw(picture, {-100.0, 20.0}, "H", kBlack);
    font.draw(picture, {5.0, 200.0}, "H", kBlack);
    EXPECT_EQ(touched(picture), 0U);
    font.draw(picture, {-5.0, 5.0}, "HHHHHHHHHHHH", kBlack);
    EXPECT_GT(touched(picture), 0U);
}

TEST(Font, OnATransparentGroundLettersAreOpaque) {
    Picture picture = blank(kTransparent);
    Font(20.0).draw(picture, {5.0, 20.0}, "H", kBlack);
    EXPECT_NE(std::find(picture.pixels.begin(), picture.pixels.end(), kBlack), picture.pixels.end());
    for (const Colour& c : picture.pixels) EXPECT_TRUE(c.alpha == 0 || c.red == 0);
}

TEST(Font, BlendingCoversByShares) {
    EXPECT_EQ(blended(kWhite, kBlack, 0.0), kWhite);
    EXPECT_EQ(blended(kWhite, kBlack, 1.0), kBlack);
    EXPECT_EQ(blended(kWhite, kBlack, 0.4), (Colour{153, 153, 153, 255}));
    EXPECT_EQ(blended(kTransparent, kBlack, 0.4), (Colour{0, 0, 0, 102}));
}

}  // namespace
}  // namespace meniscus
