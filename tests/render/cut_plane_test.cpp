// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/cut_plane.h"

#include <gtest/gtest.h>

#include <limits>

#include "meniscus/errors.h"
#include "render/small_scenes.h"

namespace meniscus {
namespace {

using testing::cheese;
using testing::kFront;

HalfSpace cut_cheese(const Cut& cut) {
    const Mesh mesh = cheese().mesh;
    return find_cut(mesh, cut, Camera(mesh.vertices, {.viewpoint = kFront}));
}

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT(norm(a - b), 0.02) << a.x << ' ' << a.y << ' ' << a.z; }

TEST(CutPlane, GoesThroughTheLargestCavityUnlessToldOtherwise) {
    const HalfSpace kept = cut_cheese({});
    expect_near(kept.point, testing::kLargeHole.centre);
    EXPECT_EQ(kept.normal, (Vec3{0, 0, 1}));
}

TEST(CutPlane, CavitiesAreNumberedByFallingVolume) {
    expect_near(cut_cheese({.through = Cut::Through::Cavity, .cavity = 1}).point, testing::kLargeHole.centre);
    expect_near(cut_cheese({.through = Cut::Through::Cavity, .cavity = 2}).point, testing::kSmallHole.centre);
    EXPECT_THROW(cut_cheese({.through = Cut::Through::Cavity, .cavity = 3}), UsageError);
    EXPECT_THROW(cut_cheese({.through = Cut::Through::Cavity, .cavity = 0}), UsageError);
}

TEST(CutPlane, DepthIsCountedFromTheNearestPoint) {
    EXPECT_NEAR(cut_cheese({.through = Cut::Through::Depth, .depth = 1.5}).point.z, testing::kCheese.radius - 1.5,
                1e-3);
}

TEST(CutPlane, WithoutACavityItIsInTheMiddle) {
    const Mesh ball = testing::blue_sphere({.centre = {0, 0, 5}, .radius = 2.0}, 0.3).mesh;
    EXPECT_NEAR(find_cut(ball, {}, Camera(ball.vertices, {.viewpoint = kFront})).point.z, 5.0, 0.01);
}

TEST(CutPlane, PointAndNormalAreTakenAsGiven) {
    const HalfSpace kept = cut_cheese({.through = Cut::Through::Point, .point = {1, 2, 3}, .normal = Vec3{0, -4, 0}});
    EXPECT_EQ(kept.point, (Vec3{1, 2, 3}));
    EXPECT_EQ(kept.normal, (Vec3{0, -1, 0}));
    EXPECT_THROW(cut_cheese({.normal = Vec3{}}), UsageError);
    EXPECT_THROW(cut_cheese({.through = Cut::Through::Depth, .depth = std::numeric_limits<double>::quiet_NaN()}),
                 UsageError);
}

TEST(CutPlane, OnlyWhatIsClosedAndHasAnOutsideIsABody) {
    Mesh mesh = cheese().mesh;
    EXPECT_TRUE(is_body(mesh));
    Mesh open = mesh;
    open.triangles.pop_back();
    EXPECT_FALSE(is_body(open));
    EXPECT_FALSE(is_body(testing::turned_inside_out(mesh)));
    EXPECT_FALSE(is_body({}));
}

}  // namespace
}  // namespace meniscus
