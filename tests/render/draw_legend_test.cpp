// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "meniscus/errors.h"
#include "meniscus/legend.h"
#include "meniscus/picture.h"
#include "render/small_scenes.h"

namespace meniscus {
namespace {

using testing::pixel;

constexpr Colour kRed{200, 30, 30, 255};
constexpr Colour kGreen{30, 160, 30, 255};

Legend two_chains() { return {.title = "Chain", .entries = {{"A", kRed}, {"B", kGreen}}}; }

std::int64_t count_of(const Picture& picture, const Colour& colour) {
    return std::count(picture.pixels.begin(), picture.pixels.end(), colour);
}

/// The first row that has a colour.
int first_row(const Picture& picture, const Colour& colour) {
    const auto found = std::find(picture.pixels.begin(), picture.pixels.end(), colour);
    return static_cast<int>((found - picture.pixels.begin()) / picture.width);
}

TEST(DrawLegend, ShowsClassesInTheirOrder) {
    const Picture picture = draw_legend(two_chains(), {.width = 400, .height = 600});
    EXPECT_EQ(picture.height, 600);
    EXPECT_LE(picture.width, 400);
    EXPECT_GT(picture.width, 50);
    EXPECT_GT(count_of(picture, kRed), 50);
    EXPECT_EQ(count_of(picture, kRed), count_of(picture, kGreen));
    EXPECT_LT(first_row(picture, kRed), first_row(picture, kGreen));
    EXPECT_GT(count_of(picture, kWhite), static_cast<std::int64_t>(picture.pixels.size() / 2));
}

TEST(DrawLegend, ARampHasItsLargestValueOnTop) {
    const Legend legend{.title = "Depth, Å", .ramp = {kRed, kGreen}, .range = {0.0, 10.0}};
    const Picture picture = draw_legend(legend, {.width = 400, .height = 600});
    const auto most = [&](auto channel) {
        const auto place = std::max_element(picture.pixels.begin(), picture.pixels.end(),
                                            [&](const Colour& a, const Colour& b) { return channel(a) < channel(b); });
        return (place - picture.pixels.begin()) / picture.width;
    };
    EXPECT_LT(most([](const Colour& c) { return c.green - c.red; }),
              most([](const Colour& c) { return c.red - c.green; }));
}

TEST(DrawLegend, ALegendWithoutColoursTakesNoRoom) { EXPECT_EQ(draw_legend({.title = ""}, {.height = 100}).width, 0); }

TEST(DrawLegend, ManyClassesStandInColumnsAndLettersShrink) {
    Legend legend{.title = "Chain"};
    for (int i = 0; i < 60; ++i)
        legend.entries.push_back({"chain " + std::to_string(i), Colour{static_cast<std::uint8_t>(i), 0, 200, 255}});
    const Picture picture = draw_legend(legend, {.width = 500, .height = 300});
    EXPECT_LE(picture.width, 500);
    for (const LegendEntry& entry : legend.entries) EXPECT_GT(count_of(picture, entry.colour), 4) << entry.label;
    const Picture small = draw_legend(legend, {.width = 100, .height = 100});
    EXPECT_LE(small.width, 100);
    EXPECT_GT(count_of(small, legend.entries.front().colour), 4);
    EXPECT_EQ(count_of(small, legend.entries.back().colour), 0);
    EXPECT_THROW(draw_legend(legend, {.width = 20, .height = 20}), UsageError);
}

TEST(DrawLegend, LabelsMayBeAnything) {
    Legend legend = two_chains();
    legend.entries[0].label = std::string(10000, 'W');
    legend.entries[1].label = "\xFF\n漢";
    EXPECT_LE(draw_legend(legend, {.width = 400, .height = 600}).width, 400);
    legend.title = std::string(500, 'x') + " and more";
    EXPECT_LE(draw_legend(legend, {.width = 400, .height = 600}).width, 400);
}

TEST(DrawLegend, TextIsLightOnDarkAndDarkOnNothing) {
    const auto brightest_and_darkest = [](const Colour& background) {
        const Picture picture = draw_legend(two_chains(), {.width = 400, .height = 600, .background = background});
        int low = 255;
        int high = 0;
        for (const Colour& c : picture.pixels) {
            if (c == background || c.alpha < 255 || std::max(c.red, c.green) - c.blue > 20) continue;
            low = std::min<int>(low, c.blue);
            high = std::max<int>(high, c.blue);
        }
        return std::pair{low, high};
    };
    EXPECT_GT(brightest_and_darkest({0, 0, 0, 255}).second, 200);
    EXPECT_LT(brightest_and_darkest(kTransparent).first, 60);
    EXPECT_LT(brightest_and_darkest(kWhite).first, 60);
}

TEST(DrawLegend, PicturesStandSideBySide) {
    const Picture left{1, 2, {kRed, kGreen}};
    const Picture right{2, 2, {kWhite, kRed, kGreen, kWhite}};
    const Picture both = side_by_side(left, right);
    EXPECT_EQ(both.width, 3);
    EXPECT_EQ(both.pixels, (std::vector<Colour>{kRed, kWhite, kRed, kGreen, kGreen, kWhite}));
    EXPECT_EQ(side_by_side(left, {0, 2, {}}).pixels, left.pixels);
    EXPECT_THROW(side_by_side(left, {1, 1, {kRed}}), UsageError);
}

}  // namespace
}  // namespace meniscus
