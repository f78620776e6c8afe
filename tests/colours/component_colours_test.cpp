// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/component_colours.h"

#include <gtest/gtest.h>

#include <vector>

#include "colours/palettes.h"
#include "colours/small_meshes.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

TEST(ComponentColours, OuterPiecesArePlainAndCavitiesTakeTheDistinctColoursInTurn) {
    const std::vector<Colour> expected{kPlain, kPlain, distinct_colour(1), distinct_colour(2)};
    EXPECT_EQ(component_colours(testing::two_outer_pieces_and_two_cavities().first), expected);
}

TEST(ComponentColours, NoCavityHasTheColourOfOuterPiecesHoweverManyThereAre) {
    const Mesh cavity = testing::turned_inside_out(testing::tetrahedron());
    Mesh mesh;
    for (std::uint32_t i = 0; i < 30; ++i) {
        testing::append(mesh, cavity);
        mesh.components.resize(mesh.vertices.size(), i);
    }
    const std::vector<Colour> colours = component_colours(mesh);
    ASSERT_EQ(colours.size(), 30U);
    for (const Colour& colour : colours) EXPECT_NE(colour, kPlain);
    for (std::size_t i = 1; i < colours.size(); ++i) EXPECT_NE(colours[i], colours[0]) << i;
}

TEST(ComponentColours, AnEmptyMeshHasNone) { EXPECT_TRUE(component_colours({}).empty()); }

}  // namespace
}  // namespace meniscus
