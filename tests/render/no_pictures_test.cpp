// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Of a build with MENISCUS_PICTURES=OFF.
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "render/openness.h"
#include "render/small_scenes.h"

namespace meniscus {
namespace {

TEST(NoPictures, WhatDrawsRefuses) {
    const testing::ColouredMesh ball = testing::blue_sphere({{0, 0, 0}, 3.0}, 0.5);
    EXPECT_FALSE(pictures_supported());
    EXPECT_THROW(draw_picture(ball.mesh, ball.colours), UsageError);
    EXPECT_THROW(side_by_side({}, {}), UsageError);
}

TEST(NoPictures, PagesHaveTheirLight) {
    const Mesh ball = testing::blue_sphere({{0, 0, 0}, 3.0}, 0.5).mesh;
    for (const float share : openness(ball)) EXPECT_GT(share, 0.97F);
}

}  // namespace
}  // namespace meniscus
