// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "cavities/filled_space.h"

#include <gtest/gtest.h>

#include "meniscus/surface.h"

#include "mesh/components.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

// A ball of 5 Å with a cavity of 2 Å that is filled.
Surface ball_with_filled_cavity() {
    Surface surface;
    surface.options.spacing = 0.5;
    surface.filled.cavities = 1;
    surface.filled.walls = turned_inside_out(extracted_sphere({{0, 0, 0}, 2.0}, 0.25));
    label_components(surface.filled.walls);
    surface.filled.rest = extracted_sphere({{0, 0, 0}, 5.0}, 0.25);
    return surface;
}

TEST(FilledSpace, WithoutCavitiesNothingChanges) {
    const Surface surface;
    const FilledSpace space(surface.filled, surface.options.spacing);
    EXPECT_TRUE(space.empty());
    EXPECT_FALSE(space.contains({0, 0, 0}));
    EXPECT_EQ(space.distance({0, 0, 0}, 1.5), 1.5);
}

TEST(FilledSpace, IsWithinTheWalls) {
    const Surface surface = ball_with_filled_cavity();
    const FilledSpace space(surface.filled, surface.options.spacing);
    EXPECT_TRUE(space.contains({0, 0, 0}));
    EXPECT_TRUE(space.contains({1.1, 1.1, 1.1}));
    EXPECT_FALSE(space.contains({1.3, 1.3, 1.3}));  // in the box
    EXPECT_FALSE(space.contains({3, 0, 0}));
}

TEST(FilledSpace, TheDistanceIsToWhatIsLeft) {
    const Surface surface = ball_with_filled_cavity();
    const FilledSpace space(surface.filled, surface.options.spacing);
    for (double r = 0.0; r < 7.0; r += 0.1) {
        const double with_cavity = std::max(r - 5.0, 2.0 - r);
        EXPECT_NEAR(space.distance({0, r, 0}, with_cavity), r - 5.0, 0.05) << r;
    }
}

}  // namespace
}  // namespace meniscus::testing
