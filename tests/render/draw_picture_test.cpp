// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meniscus/errors.h"
#include "meniscus/picture.h"
#include "render/draw_by.h"
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

/// Pixels of the section, and others that are not background.
std::pair<int, int> section_and_surface(const Picture& picture) {
    const Colour section = pixel(picture, picture.width / 2, picture.height - 20);
    EXPECT_LT(std::abs(section.red - section.blue), 20) << "grey";
    int of_section = 0;
    int others = 0;
    for (const Colour& c : picture.pixels) {
        of_section += c == section ? 1 : 0;
        others += c != section && c.alpha > 127 ? 1 : 0;
    }
    return {of_section, others};
}

TEST(DrawPicture, ACutShowsTheSectionAndTheHolesInIt) {
    const ColouredMesh cheese = testing::cheese();
    PictureOptions options{.width = 400, .height = 400, .viewpoint = kFront, .background = kTransparent};
    const Picture whole = draw_picture(cheese.mesh, cheese.colours, options);
    options.cut = Cut{.through = Cut::Through::Point};  // z = 0
    const Picture cut = draw_picture(cheese.mesh, cheese.colours, options);
    for (std::size_t i = 0; i < cut.pixels.size(); ++i) EXPECT_EQ(cut.pixels[i].alpha, whole.pixels[i].alpha);
    const double scale = 0.92 * 400 / 8.0;  // pixels per Å
    const double hole_1 = 1.0;              // squared radii, where z = 0 cuts the spheres
    const double hole_2 = 1.5 * 1.5 - 0.5 * 0.5;
    const double pi = 3.14159265;
    const double section = pi * (16.0 - hole_1 - hole_2) * scale * scale;
    const double line = 2.0 * pi * (4.0 + 1.0 + std::sqrt(hole_2)) * scale;  // its length
    const auto [of_section, others] = section_and_surface(cut);
    EXPECT_LT(of_section, section - line) << "the line lies within the section";
    EXPECT_GT(of_section, section - 4.0 * line);
    EXPECT_NEAR(of_section + others, pi * 16.0 * scale * scale, 0.01 * section);
    const auto x = static_cast<int>(200 + 1.5 * scale);
    EXPECT_GT(pixel(cut, x, 200).blue, pixel(cut, x, 200).red + 20) << "the wall of the larger hole";
}

TEST(DrawPicture, WhatACutLeavesOutIsNotThere) {
    const ColouredMesh cheese = testing::cheese();
    PictureOptions options{.width = 200, .height = 200, .viewpoint = kFront, .background = kTransparent};
    options.cut = Cut{.through = Cut::Through::Point, .normal = Vec3{1, 0, 0}};
    const Picture half = draw_picture(cheese.mesh, cheese.colours, options);
    EXPECT_EQ(pixel(half, 150, 100).alpha, 0);
    EXPECT_EQ(pixel(half, 50, 100).alpha, 255);
    options.cut = Cut{.through = Cut::Through::Depth, .depth = 100.0};
    for (const Colour& c : draw_picture(cheese.mesh, cheese.colours, options).pixels) EXPECT_EQ(c.alpha, 0);
    options.cut = Cut{.through = Cut::Through::Depth, .depth = 0.0};
    const Picture all = draw_picture(cheese.mesh, cheese.colours, options);
    options.cut.reset();
    EXPECT_EQ(all.pixels, draw_picture(cheese.mesh, cheese.colours, options).pixels);
}

TEST(DrawPicture, WallsOfCavitiesAloneHaveNoSection) {
    const ColouredMesh wall = testing::turned_inside_out(blue_sphere({.centre = {}, .radius = 3.0}, 0.2));
    PictureOptions options{.width = 200, .height = 200, .viewpoint = kFront, .background = kTransparent};
    options.cut = Cut{};
    for (const Colour& c : draw_picture(wall.mesh, wall.colours, options).pixels)
        EXPECT_TRUE(c.alpha < 255 || c.blue > c.red) << "no grey";
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
    refused({.cut = Cut{.through = Cut::Through::Cavity}});
    refused({.cut = Cut{.normal = Vec3{}}});
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

TEST(DrawPicture, UsesTheSkyItIsGiven) {
    const ColouredMesh ball = blue_sphere({{0, 0, 0}, 3.0}, 0.5);
    const std::vector<float> night(ball.mesh.vertices.size(), 0.0F);
    const PictureOptions options{.width = 20, .height = 20};
    const Picture dark = draw_picture_by(night, ball.mesh, ball.colours, options);
    const Picture light = draw_picture(ball.mesh, ball.colours, options);
    EXPECT_LT(pixel(dark, 10, 10).blue, pixel(light, 10, 10).blue);
}

}  // namespace
}  // namespace meniscus
