// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/view_frame.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

void expect_near(const Vec3& a, const Vec3& b) { EXPECT_LT(norm(a - b), 1e-12) << a.x << ' ' << a.y << ' ' << a.z; }

void expect_right_handed(const ViewFrame& frame) {
    expect_near(cross(frame.right, frame.up), frame.towards);
    EXPECT_NEAR(norm(frame.right), 1.0, 1e-12);
    EXPECT_NEAR(dot(frame.right, frame.up), 0.0, 1e-12);
}

/// A long arm along x, a shorter one along y, a bump towards z.
std::vector<Vec3> lopsided() { return {{-5, 0, 0}, {5, 0, 0}, {0, -1, 0}, {0, 3, 0}, {0, 0, 1}, {0, 0, -0.2}}; }

/// The same, turned so that x goes to y, y to z and z to x.
std::vector<Vec3> turned(std::vector<Vec3> points) {
    for (Vec3& p : points) p = {p.z, p.x, p.y};
    return points;
}

TEST(ViewFrame, UpIsMadePerpendicular) {
    const ViewFrame frame = frame_of({.from = {0, 0, 5}, .up = {0, 2, 7}});
    expect_near(frame.right, {1, 0, 0});
    expect_near(frame.up, {0, 1, 0});
    expect_right_handed(frame_of({.from = {1, 2, 3}, .up = {0, 1, 0}}));
}

TEST(ViewFrame, DirectionsThatSayNothingAreRefused) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(frame_of({.from = {0, 0, 0}, .up = {0, 1, 0}}), UsageError);
    EXPECT_THROW(frame_of({.from = {0, 1, 0}, .up = {0, -2, 0}}), UsageError);
    EXPECT_THROW(frame_of({.from = {0, kNan, 1}, .up = {0, 1, 0}}), UsageError);
}

TEST(ViewFrame, TheLongestAxisLiesAcross) {
    const ViewFrame frame = principal_frame(lopsided());
    EXPECT_GT(std::abs(frame.right.x), 0.99);
    EXPECT_GT(frame.up.y, 0.99);
    EXPECT_GT(frame.towards.z, 0.99);
    expect_right_handed(frame);
}

TEST(ViewFrame, TheFrameTurnsWithThePoints) {
    const ViewFrame frame = principal_frame(turned(lopsided()));
    const ViewFrame unturned = principal_frame(lopsided());
    expect_near(frame.up, {unturned.up.z, unturned.up.x, unturned.up.y});
    expect_near(frame.towards, {unturned.towards.z, unturned.towards.x, unturned.towards.y});
}

TEST(ViewFrame, AnyPointsHaveAFrame) {
    expect_right_handed(principal_frame({}));
    expect_right_handed(principal_frame(std::vector<Vec3>{{3, 4, 5}}));
    expect_right_handed(principal_frame(std::vector<Vec3>{{0, 0, 0}, {1, 1, 1}}));
}

}  // namespace
}  // namespace meniscus
