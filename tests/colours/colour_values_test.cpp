// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "colours/palettes.h"
#include "meniscus/colours.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

TEST(ColourValues, BlueToRedThroughTheMiddle) {
    const std::vector<float> values{-9.0F, -2.0F, 0.0F, 2.0F, 9.0F, std::numeric_limits<float>::quiet_NaN()};
    const std::vector<Colour> colours = colour_values(values, {-2.0, 2.0});
    EXPECT_EQ(colours[0], diverging_ramp().front());
    EXPECT_EQ(colours[1], colours[0]);
    EXPECT_EQ(colours[2], ramp_colour(diverging_ramp(), 0.5));
    EXPECT_EQ(colours[3], diverging_ramp().back());
    EXPECT_EQ(colours[4], colours[3]);
    EXPECT_EQ(colours[5], kNeutral);
    EXPECT_GT(colours[0].blue, colours[0].red);
    EXPECT_GT(colours[4].red, colours[4].blue);
}

TEST(ColourValues, RefusesRangesThatAreNone) {
    for (const ValueRange& range : {ValueRange{1.0, 1.0}, ValueRange{2.0, 1.0}, ValueRange{0.0, INFINITY}})
        EXPECT_THROW(colour_values({}, range), UsageError);
}

}  // namespace
}  // namespace meniscus
