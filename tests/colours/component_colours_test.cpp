// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/component_colours.h"

#include <gtest/gtest.h>

#include <vector>

#include "colours/palettes.h"
#include "colours/small_meshes.h"

namespace meniscus {
namespace {

TEST(ComponentColours, OuterPiecesArePlainAndCavitiesTakeTheDistinctColoursInTurn) {
    const std::vector<Colour> expected{kPlain, kPlain, distinct_colour(1), distinct_colour(2)};
    EXPECT_EQ(component_colours(testing::two_outer_pieces_and_two_cavities().first), expected);
}

TEST(ComponentColours, AnEmptyMeshHasNone) { EXPECT_TRUE(component_colours({}).empty()); }

}  // namespace
}  // namespace meniscus
