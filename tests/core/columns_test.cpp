// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/columns.h"

#include <gtest/gtest.h>

namespace meniscus::testing {
namespace {

TEST(Columns, ArePaddedToWholeSteps) {
    Columns<2> doubles;
    static_assert(Columns<2>::kStep == 8);
    static_assert(Columns<2, float>::kStep == 16);
    EXPECT_EQ(doubles.padded_size(), 0U);
    doubles.resize(8);
    EXPECT_EQ(doubles.padded_size(), 8U);
    doubles.resize(9);
    EXPECT_EQ(doubles.size(), 9U);
    EXPECT_EQ(doubles.padded_size(), 16U);
    for (std::size_t column = 0; column < 2; ++column) doubles[column][15] = 1.0;  // may be written
}

TEST(Columns, KeepWhatTheyHoldWhenTheyGrowOrShrink) {
    Columns<3, float> places;
    places.resize(1);
    set_position(places, 0, {1.0F, 2.0F, 3.0F});
    places.resize(1000);
    set_position(places, 999, {4.0F, 5.0F, 6.0F});
    places.resize(1);
    EXPECT_EQ(position_in(places, 0), (SmallVec3{1.0F, 2.0F, 3.0F}));
    places.resize(1000);
    EXPECT_EQ(position_in(places, 999), (SmallVec3{4.0F, 5.0F, 6.0F}));
}

}  // namespace
}  // namespace meniscus::testing
