// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/small_scenes.h"

namespace meniscus {
namespace {

using testing::blue_sphere;
using testing::ColouredMesh;
using testing::kBlue;
using testing::kFront;
using testing::kNoBodies;

constexpr PictureOptions kOptions{.width = 100, .height = 100, .viewpoint = kFront};
const ColourField kNone;

Glimpse look(const Scene& scene, double x, double y) {
    const Spot spot{x, y};
    return scene.look({&spot, 1}).front();
}

TEST(Scene, TheMiddleIsNearAndTheCornerIsBackground) {
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), kOptions, kNone, kNoBodies);
    EXPECT_NEAR(look(scene, 50, 50).depth, 0.0, 0.02);
    EXPECT_NEAR(look(scene, 50 + 23, 50).depth, 2.0 - std::sqrt(3.0), 0.02);
    EXPECT_TRUE(look(scene, 1, 1).is_background());
    EXPECT_EQ(to_colour(look(scene, 1, 1).light, 1.0F), kWhite);
}

TEST(Scene, ColoursAreAskedForOnlyWhereCornersDiffer) {
    ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    const ColourField red = [](auto, std::span<Colour> colours) {
        std::fill(colours.begin(), colours.end(), Colour{255, 0, 0, 255});
    };
    const Scene uniform({ball.mesh, ball.colours}, RayScene(ball.mesh), kOptions, red, kNoBodies);
    EXPECT_GT(look(uniform, 50, 50).light.blue, 0.1F);
    for (std::size_t v = 0; v < ball.colours.size(); ++v) ball.colours[v].green = static_cast<std::uint8_t>(v % 256);
    const Scene mixed_colours({ball.mesh, ball.colours}, RayScene(ball.mesh), kOptions, red, kNoBodies);
    EXPECT_LT(look(mixed_colours, 50, 50).light.blue, 0.1F);
    const Scene interpolated({ball.mesh, ball.colours}, RayScene(ball.mesh), kOptions, kNone, kNoBodies);
    EXPECT_GT(look(interpolated, 50, 50).light.blue, 0.1F);
}

TEST(Scene, ACutShowsItsPlaneWhereItIsInTheMolecule) {
    const ColouredMesh cheese = testing::cheese();
    PictureOptions options = kOptions;
    options.cut = Cut{};
    const Scene scene({cheese.mesh, cheese.colours}, RayScene(cheese.mesh), options, kNone, kNoBodies);
    const Glimpse section = look(scene, 50, 80);
    EXPECT_EQ(section.kind, Glimpse::Kind::Section);
    EXPECT_NEAR(section.depth, testing::kCheese.radius - testing::kLargeHole.centre.z, 0.02);
    const Glimpse wall = look(scene, 50 + 1.5 * 92 / 8.0, 50);
    EXPECT_EQ(wall.kind, Glimpse::Kind::Surface);
    EXPECT_NEAR(wall.depth, section.depth + testing::kLargeHole.radius, 0.02);
    EXPECT_TRUE(look(scene, 1, 1).is_background());
}

TEST(Scene, TheDepthCueBeginsAtACut) {
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    PictureOptions options = kOptions;
    options.cut = Cut{};
    const Light clear =
        look(Scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNone, kNoBodies), 50, 50).light;
    options.depth_cue = 1.0;
    EXPECT_NEAR(
        look(Scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNone, kNoBodies), 50, 50).light.red,
        clear.red, 0.03);
}

TEST(Scene, TheDepthCueFadesWhatIsFar) {
    ColouredMesh balls = blue_sphere({.centre = {-3, 0, 5}, .radius = 1.0}, 0.3);
    append(balls, blue_sphere({.centre = {3, 0, -5}, .radius = 1.0}, 0.3));
    PictureOptions options = kOptions;
    const Scene clear({balls.mesh, balls.colours}, RayScene(balls.mesh), options, kNone, kNoBodies);
    PictureOptions hazy_options = kOptions;
    hazy_options.depth_cue = 1.0;
    const Scene hazy({balls.mesh, balls.colours}, RayScene(balls.mesh), hazy_options, kNone, kNoBodies);
    EXPECT_NEAR(look(hazy, 16, 50).light.red, look(clear, 16, 50).light.red, 0.01);
    EXPECT_GT(look(hazy, 84, 50).light.red, 0.8F);
}

/// A red ball on the axis of view, its middle at this height.
Bodies red_ball(double z) {
    Bodies ball{.mesh = testing::projected_sphere({.centre = {0, 0, z}, .radius = 0.5}, 0.1), .colours = {}};
    ball.mesh.components.assign(ball.mesh.vertices.size(), 0);
    ball.colours.assign(ball.mesh.vertices.size(), Colour{255, 0, 0, 255});
    return ball;
}

TEST(Scene, BodiesAreSeenBeforeTheSurfaceNotBehindIt) {
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    const RayScene rays(ball.mesh);
    for (const double z : {3.0, 0.0, -3.0}) {
        const Bodies red = red_ball(z);
        const Scene scene({ball.mesh, ball.colours}, rays, kOptions, kNone, red);
        EXPECT_EQ(look(scene, 50, 50).kind, z > 2.0 ? Glimpse::Kind::Body : Glimpse::Kind::Surface) << z;
        EXPECT_EQ(look(scene, 50, 50).light.red > look(scene, 50, 50).light.blue, z > 2.0) << z;
    }
}

TEST(Scene, BodiesAndBackgroundShineThroughAClearSurface) {
    const ColouredMesh ball = testing::blue_sphere({.centre = {}, .radius = 2.0}, 0.2);
    const auto seen = [&](const Bodies& bodies, double opacity) {
        PictureOptions options = kOptions;
        options.opacity = opacity;
        return look(Scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNone, bodies), 50, 50);
    };
    const Light solid = seen(kNoBodies, 1.0).light;
    const Light clear = seen(kNoBodies, 0.25).light;  // before a white background
    EXPECT_NEAR(clear.red, 0.25F * solid.red + 0.75F, 1e-5F);
    const Bodies red = red_ball(0.0);
    EXPECT_EQ(seen(red, 1.0).light.green, solid.green);
    const Glimpse through = seen(red, 0.25);
    EXPECT_EQ(through.kind, Glimpse::Kind::Surface);
    EXPECT_LT(through.light.green, clear.green - 0.5F);
    EXPECT_NEAR(seen(red, 0.0).light.green, seen(red_ball(4.0), 1.0).light.green, 0.01F);
}

TEST(Scene, AClearBodyShowsWhatIsBehindIt) {
    const ColouredMesh ball = testing::blue_sphere({.centre = {}, .radius = 2.0}, 0.2);
    const auto seen = [&](const Bodies& bodies) {
        return look(Scene({ball.mesh, ball.colours}, RayScene(ball.mesh), kOptions, kNone, bodies), 50, 50);
    };
    Bodies body = red_ball(4.0);
    const Light solid = seen(body).light;
    for (Colour& colour : body.colours) colour.alpha = 51;  // a fifth
    const Glimpse clear = seen(body);
    EXPECT_EQ(clear.kind, Glimpse::Kind::Body);
    EXPECT_NEAR(clear.light.blue, 0.2F * solid.blue + 0.8F * seen(kNoBodies).light.blue, 1e-5F);
    body = red_ball(0.0);
    for (Colour& colour : body.colours) colour.alpha = 51;
    EXPECT_EQ(seen(body).kind, Glimpse::Kind::Surface);
}

TEST(Scene, ACutLeavesBodiesWholeOrOut) {
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    PictureOptions options = kOptions;
    options.cut = Cut{.point = Vec3{0, 0, 0}, .normal = Vec3{0, 0, 1}};
    for (const double z : {0.3, 1.0}) {
        const Bodies red = red_ball(z);
        const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), options, kNone, red);
        EXPECT_EQ(look(scene, 50, 50).kind, z < 0.5 ? Glimpse::Kind::Body : Glimpse::Kind::Section) << z;
    }
}

TEST(Scene, TheInsideOfAnOpenMeshIsLit) {
    ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    std::erase_if(ball.mesh.triangles, [&](const Triangle& t) { return ball.mesh.vertices[t[0]].z > 0.5; });
    const Scene scene({ball.mesh, ball.colours}, RayScene(ball.mesh), kOptions, kNone, kNoBodies);
    EXPECT_NEAR(look(scene, 50, 50).depth, 4.0, 0.05);
    EXPECT_GT(look(scene, 50, 50).light.blue, 0.05F);
}

TEST(Scene, TheWallOfACavityAloneLooksLikeABall) {
    const ColouredMesh ball = blue_sphere({.centre = {}, .radius = 2.0}, 0.3);
    ColouredMesh wall = ball;
    wall.mesh = testing::turned_inside_out(ball.mesh);
    for (SmallVec3& normal : wall.mesh.normals) normal = -normal;
    const Light seen =
        look(Scene({wall.mesh, wall.colours}, RayScene(wall.mesh), kOptions, kNone, kNoBodies), 50, 50).light;
    EXPECT_NEAR(
        seen.blue,
        look(Scene({ball.mesh, ball.colours}, RayScene(ball.mesh), kOptions, kNone, kNoBodies), 50, 50).light.blue,
        1e-3);
}

}  // namespace
}  // namespace meniscus
