// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tile.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/small_scenes.h"

namespace meniscus {
namespace {

using testing::blue_sphere;
using testing::ColouredMesh;
using testing::kFront;
using testing::kNoBodies;
using testing::pixel;

const ColourField kNoField;

Picture blank(const PictureOptions& options) {
    const auto size = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
    return {options.width, options.height, std::vector<Colour>(size, Colour{1, 2, 3, 4})};
}

TEST(Tile, WritesItsBoxAndNothingElse) {
    const PictureOptions options{.width = 40, .height = 30, .viewpoint = kFront};
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNoField, kNoBodies);
    Picture picture = blank(options);
    Tile(scene, options, {10, 5, 8, 6}).draw(picture);
    for (int y = 0; y < 30; ++y)
        for (int x = 0; x < 40; ++x) {
            const bool inside = x >= 10 && x < 18 && y >= 5 && y < 11;
            EXPECT_EQ(pixel(picture, x, y).alpha, inside ? 255 : 4) << x << ' ' << y;
        }
}

TEST(Tile, TheDivisionIntoTilesCannotBeSeen) {
    const PictureOptions options{.width = 40, .height = 30, .viewpoint = kFront, .outline = true};
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNoField, kNoBodies);
    Picture whole = blank(options);
    Tile(scene, options, {0, 0, 40, 30}).draw(whole);
    Picture parts = blank(options);
    for (const PixelBox& box : {PixelBox{0, 0, 13, 30}, PixelBox{13, 0, 27, 7}, PixelBox{13, 7, 27, 23}})
        Tile(scene, options, box).draw(parts);
    EXPECT_EQ(whole.pixels, parts.pixels);
}

TEST(Tile, EdgesAreSmooth) {
    const PictureOptions options{.width = 100, .height = 100, .viewpoint = kFront, .background = kTransparent};
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.1);
    const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNoField, kNoBodies);
    Picture picture = blank(options);
    Tile(scene, options, {0, 0, 100, 100}).draw(picture);
    double covered = 0.0;
    for (const Colour& c : picture.pixels) covered += c.alpha / 255.0;
    const double radius = 46.0;  // the sphere fills 92 % of the picture
    EXPECT_NEAR(covered, 3.14159265 * radius * radius, 0.003 * covered);
}

TEST(Tile, ASectionHasALineAround) {
    PictureOptions options{.width = 100, .height = 100, .viewpoint = kFront, .cut = Cut{}};
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.1);
    const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNoField, kNoBodies);
    Picture picture = blank(options);
    Tile(scene, options, {0, 0, 100, 100}).draw(picture);
    const Colour& section = pixel(picture, 50, 50);
    EXPECT_EQ(pixel(picture, 30, 60), section) << "flat";
    EXPECT_LT(pixel(picture, 50 + 45, 50).red, section.red / 2);
    EXPECT_EQ(pixel(picture, 50 + 41, 50), section);
}

TEST(Tile, LinesAreDarkAndWithinTheSilhouette) {
    PictureOptions options{.width = 100, .height = 100, .viewpoint = kFront, .background = kTransparent};
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.1);
    const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNoField, kNoBodies);
    Picture plain = blank(options);
    Tile(scene, options, {0, 0, 100, 100}).draw(plain);
    options.outline = true;
    Picture lined = blank(options);
    Tile(scene, options, {0, 0, 100, 100}).draw(lined);
    int darker = 0;
    for (std::size_t i = 0; i < plain.pixels.size(); ++i) {
        EXPECT_EQ(plain.pixels[i].alpha, lined.pixels[i].alpha);
        EXPECT_LE(lined.pixels[i].blue, plain.pixels[i].blue);
        darker += lined.pixels[i].blue + 40 < plain.pixels[i].blue ? 1 : 0;
    }
    EXPECT_GT(darker, 200);  // the circumference is 289 pixels long
    EXPECT_LT(darker, 900);
    EXPECT_EQ(pixel(plain, 50, 50), pixel(lined, 50, 50));
}

}  // namespace
}  // namespace meniscus
