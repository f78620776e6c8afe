// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/palettes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <vector>

#include "support/colour_vision.h"

namespace meniscus {
namespace {

TEST(Palettes, CodesAreRedGreenBlue) { EXPECT_EQ(rgb(0x0180FF), (Colour{1, 128, 255, 255})); }

std::vector<Colour> first_colours(std::size_t count) {
    std::vector<Colour> colours;
    for (std::size_t i = 0; i < count; ++i) colours.push_back(distinct_colour(i));
    return colours;
}

/// In the eyes of one vision, over a ramp.
std::vector<double> lightness(std::span<const Colour> ramp, const testing::Vision& vision) {
    std::vector<double> values;
    for (const Colour& colour : ramp) values.push_back(testing::seen(colour, vision).l);
    return values;
}

TEST(Palettes, TheMeasureOfDifferencesIsThatOfItsAuthors) {
    // Sharma, Wu & Dalal 2005, table 1: pairs 1, 7, 9, 17, 25.
    EXPECT_NEAR(testing::difference({50, 2.6772, -79.7751}, {50, 0, -82.7485}), 2.0425, 1e-4);
    EXPECT_NEAR(testing::difference({50, 0, 0}, {50, -1, 2}), 2.3669, 1e-4);
    EXPECT_NEAR(testing::difference({50, 2.49, -0.001}, {50, -2.49, 0.0009}), 7.1792, 1e-4);
    EXPECT_NEAR(testing::difference({50, 2.5, 0}, {73, 25, -18}), 27.1492, 1e-4);
    EXPECT_NEAR(testing::difference({60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}), 1.2644, 1e-4);
}

TEST(Palettes, DistinctColoursAreToldApartByTheColourBlindToo) {
    EXPECT_GT(testing::smallest_difference(first_colours(2)), 35.0);
    EXPECT_GT(testing::smallest_difference(first_colours(4)), 10.5);
    EXPECT_GT(testing::smallest_difference(first_colours(kDistinctColours)), 7.5);
    for (std::size_t i = 0; i < kDistinctColours; ++i)
        EXPECT_GT(testing::smallest_difference(std::vector{distinct_colour(i), distinct_colour(i + 1)}), 12.5) << i;
    EXPECT_EQ(distinct_colour(0), kPlain);
}

double smallest_normal_difference(const std::vector<Colour>& colours) {
    double smallest = 100.0;
    for (std::size_t i = 0; i < colours.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            smallest = std::min(smallest, testing::difference(testing::seen(colours[i], testing::kVisions.front()),
                                                              testing::seen(colours[j], testing::kVisions.front())));
    return smallest;
}

TEST(Palettes, FurtherColoursAreToldApartInNormalVisionAndDoNotRepeat) {
    EXPECT_GT(smallest_normal_difference(first_colours(60)), 9.0);
    EXPECT_GT(smallest_normal_difference(first_colours(100)), 8.5);
    std::set<std::array<int, 3>> seen;
    for (const Colour& c : first_colours(kAllColours)) seen.insert({c.red, c.green, c.blue});
    EXPECT_EQ(seen.size(), kAllColours);
    EXPECT_FALSE(seen.contains({kNeutral.red, kNeutral.green, kNeutral.blue}));
    EXPECT_EQ(distinct_colour(kAllColours), distinct_colour(0));
}

TEST(Palettes, SequentialRampsOnlyDarken) {
    for (const auto& ramp : {warm_ramp(), cold_ramp(), passage_ramp()})
        for (const testing::Vision& vision : testing::kVisions) {
            const std::vector<double> l = lightness(ramp, vision);
            for (std::size_t i = 1; i < l.size(); ++i) EXPECT_LT(l[i], l[i - 1] - 1.5) << vision.name << ' ' << i;
            EXPECT_GT(l.front() - l.back(), 70.0);
        }
}

TEST(Palettes, DivergingRampsDarkenToBothSidesAlikeAndTheirSidesDiffer) {
    for (const auto& ramp : {diverging_ramp(), hydropathy_ramp()})
        for (const testing::Vision& vision : testing::kVisions) {
            const std::vector<double> l = lightness(ramp, vision);
            for (std::size_t i = 0; i < 4; ++i) {
                EXPECT_GT(l[i + 1], l[i]) << vision.name;
                EXPECT_GT(l[7 - i], l[8 - i]) << vision.name;
                const bool reds_are_dark = vision.name == std::string_view("protanopia");
                EXPECT_NEAR(l[i], l[8 - i], reds_are_dark ? 17.0 : 7.0) << vision.name << ' ' << i;
            }
        }
    for (const auto& ramp : {diverging_ramp(), hydropathy_ramp()})
        EXPECT_GT(testing::smallest_difference(std::vector{ramp.front(), ramp.back()}), 20.0);
}

TEST(Palettes, RampsHaveNoTwoStepsAlike) {
    for (const auto& ramp : {diverging_ramp(), hydropathy_ramp(), warm_ramp(), cold_ramp(), passage_ramp()})
        EXPECT_GT(testing::smallest_difference(ramp), 2.5);
}

TEST(Palettes, RampsAreLinearAndEndAtTheirEnds) {
    constexpr std::array kRamp{Colour{0, 0, 0}, Colour{100, 200, 50}, Colour{200, 200, 250}};
    EXPECT_EQ(ramp_colour(kRamp, 0.0), kRamp.front());
    EXPECT_EQ(ramp_colour(kRamp, 0.25), (Colour{50, 100, 25}));
    EXPECT_EQ(ramp_colour(kRamp, 0.5), kRamp[1]);
    EXPECT_EQ(ramp_colour(kRamp, 1.0), kRamp.back());
    EXPECT_EQ(ramp_colour(kRamp, -3.0), kRamp.front());
    EXPECT_EQ(ramp_colour(kRamp, 1e300), kRamp.back());
}

TEST(Palettes, DivergingRampsAreNearWhiteInTheMiddle) {
    for (const auto ramp : {diverging_ramp(), hydropathy_ramp()}) {
        const Colour middle = ramp_colour(ramp, 0.5);
        EXPECT_GT(std::min({middle.red, middle.green, middle.blue}), 240);
    }
}

}  // namespace
}  // namespace meniscus
