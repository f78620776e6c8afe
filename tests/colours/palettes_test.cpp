// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/palettes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

namespace meniscus {
namespace {

TEST(Palettes, CodesAreRedGreenBlue) { EXPECT_EQ(rgb(0x0180FF), (Colour{1, 128, 255, 255})); }

TEST(Palettes, SeventeenColoursAreDistinct) {
    for (std::size_t i = 0; i < 17; ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(distinct_colour(i), distinct_colour(j)) << i << " and " << j;
    EXPECT_EQ(distinct_colour(17), distinct_colour(0));
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
