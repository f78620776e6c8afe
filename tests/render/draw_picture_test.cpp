// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meniscus/errors.h"
#include "meniscus/picture.h"
#include "render/small_scenes.h"

namespace meniscus {
namespace {

using testing::blue_sphere;
using testing::ColouredMesh;
using testing::kFront;
using testing::pixel;

TEST(DrawPicture, ASphereIsLitInFrontOfTheExactBackground) {
    const ColouredMesh ball = blue_sphere({.centre = {5, 6, 7}, .radius = 3.0}, 0.3);
    const Colour background{12, 200, 99, 255};
    const Picture picture =
        draw_picture(ball.mesh, ball.colours, {.width = 200, .height = 150, .background = background});
    ASSERT_EQ(picture.pixels.size(), 200U * 150U);
    const Colour& middle = pixel(picture, 100, 75);
    EXPECT_GT(middle.blue, 150);
    EXPECT_GT(middle.blue, middle.red);
    for (const auto& [x, y] : {std::pair{0, 0}, {199, 0}, {0, 149}, {199, 149}, {100, 2}})
        EXPECT_EQ(pixel(picture, x, y), background) << x << ' ' << y;
}

TEST(DrawPicture, TheSilhouetteHasTheRightSize) {
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 3.0}, 0.1);
    const Picture picture = draw_picture(
        ball.mesh, ball.colours, {.width = 301, .height = 201, .viewpoint = kFront, .background = kTransparent});
    int across = 0;
    int down = 0;
    for (int x = 0; x < 301; ++x) across += pixel(picture, x, 100).alpha > 127 ? 1 : 0;
    for (int y = 0; y < 201; ++y) down += pixel(picture, 150, y).alpha > 127 ? 1 : 0;
    EXPECT_NEAR(across, 0.92 * 201, 1.0);
    EXPECT_NEAR(down, 0.92 * 201, 1.0);
}

TEST(DrawPicture, WhatIsNearerIsLargerInPerspectiveOnly) {
    ColouredMesh balls = blue_sphere({.centre = {-3, 0, 6}, .radius = 1.0}, 0.2);
    append(balls, blue_sphere({.centre = {3, 0, -6}, .radius = 1.0}, 0.2));
    PictureOptions options{.width = 300, .height = 100, .viewpoint = kFront, .background = kTransparent};
    const auto covered = [](const Picture& picture, int from, int to) {
        int pixels = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = from; x < to; ++x) pixels += pixel(picture, x, y).alpha > 127 ? 1 : 0;
        return pixels;
    };
    const Picture flat = draw_picture(balls.mesh, balls.colours, options);
    EXPECT_NEAR(covered(flat, 0, 150), covered(flat, 150, 300), 30);
    options.projection = Projection::Perspective;
    const Picture deep = draw_picture(balls.mesh, balls.colours, options);
    EXPECT_GT(covered(deep, 0, 150), 1.3 * covered(deep, 150, 300));
}

TEST(DrawPicture, TheSameBitsForAnyNumberOfThreads) {
    ColouredMesh balls = blue_sphere({.centre = {-3, 0, 6}, .radius = 2.0}, 0.2);
    append(balls, blue_sphere({.centre = {-1, 1, 3}, .radius = 2.0}, 0.2));
    for (std::size_t v = 0; v < balls.colours.size(); ++v) balls.colours[v].red = static_cast<std::uint8_t>(v % 251);
    PictureOptions options{.width = 400, .height = 300, .outline = true, .depth_cue = 0.3, .threads = 1};
    const Picture one = draw_picture(balls.mesh, balls.colours, options);
    for (const int threads : {2, 3}) {
        options.threads = threads;
        EXPECT_EQ(draw_picture(balls.mesh, balls.colours, options).pixels, one.pixels);
    }
}

TEST(DrawPicture, AnEmptyMeshIsBackground) {
    const Picture picture = draw_picture({}, {}, {.width = 3, .height = 2, .background = kTransparent});
    EXPECT_EQ(picture.pixels, std::vector<Colour>(6, kTransparent));
}

TEST(DrawPicture, WhatMakesNoSenseIsRefused) {
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 3.0}, 1.0);
    const auto refused = [&](const PictureOptions& options) {
        EXPECT_THROW(draw_picture(ball.mesh, ball.colours, options), UsageError);
    };
    refused({.width = 0});
    refused({.height = kLargestPicture + 1});
    refused({.viewpoint = Viewpoint{.from = {0, 0, 0}}});
    refused({.depth_cue = 1.5});
    refused({.depth_cue = std::numeric_limits<double>::quiet_NaN()});
    EXPECT_THROW(draw_picture(ball.mesh, {}, {}), UsageError);
    Mesh bare = ball.mesh;
    bare.normals.clear();
    EXPECT_THROW(draw_picture(bare, ball.colours, {}), UsageError);
    Mesh broken = ball.mesh;
    broken.triangles[0][1] = 1000000;
    EXPECT_THROW(draw_picture(broken, ball.colours, {}), UsageError);
}

}  // namespace
}  // namespace meniscus
