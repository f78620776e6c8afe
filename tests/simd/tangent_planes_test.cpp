// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "simd/tangent_planes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace meniscus {
namespace {

TEST(MeetingOfPlanes, IsNearestOfTheirLine) {
    // The planes x = 1 and y = 2.
    EXPECT_EQ(meeting_of_planes<Vec3>({1, 7, 8}, {1, 0, 0}, {9, 2, -4}, {0, 1, 0}, {5, 6, 3}), (Vec3{1, 2, 3}));
    // Oblique ones: the point is on both, and the way to it is across their line.
    const Vec3 a{1.0, -0.5, 0.25};
    const Vec3 normal_a = normalised({1, 2, -1});
    const Vec3 b{-0.75, 0.5, 2.0};
    const Vec3 normal_b = normalised({2, -1, 3});
    const Vec3 from{0.5, 3.0, -2.0};
    const Vec3 meeting = meeting_of_planes(a, normal_a, b, normal_b, from);
    EXPECT_NEAR(dot(normal_a, meeting - a), 0.0, 1e-14);
    EXPECT_NEAR(dot(normal_b, meeting - b), 0.0, 1e-14);
    EXPECT_NEAR(dot(cross(normal_a, normal_b), meeting - from), 0.0, 1e-14);
}

TEST(MeetingOfPlanes, WhichSideNormalsPointToDoesNotMatter) {
    const Vec3 normal_a = normalised({1, 2, -1});
    const Vec3 normal_b = normalised({2, -1, 3});
    const auto meeting = [](const Vec3& n, const Vec3& m) {
        return meeting_of_planes<Vec3>({1, 0, 0}, n, {0, 2, 0}, m, {0, 0, 3});
    };
    EXPECT_LT(norm(meeting(-normal_a, normal_b) - meeting(normal_a, normal_b)), 1e-14);
}

TEST(MeetingOfPlanes, IsNotFiniteForParallelOnes) {
    const Vec3 apart = meeting_of_planes<Vec3>({0, 0, 0}, {0, 0, 1}, {0, 0, 1}, {0, 0, 1}, {0, 0, 0.5});
    EXPECT_FALSE(std::isfinite(norm(apart)));
    const Vec3 same = meeting_of_planes<Vec3>({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {0, 0, -1}, {0, 0, 0.5});
    EXPECT_FALSE(std::isfinite(norm(same)));
}

TEST(ArcMiddle, LiesOnTheSphere) {
    const double angle = 0.1;
    const Vec3 a{1, 0, 0};
    const Vec3 b{std::cos(angle), std::sin(angle), 0};
    EXPECT_NEAR(norm(arc_middle<Vec3>(a, a, b, b)), 1.0, 0.01 * std::pow(angle, 6));
    // The wall of a cavity: the normals point to the centre and the middle is the same.
    EXPECT_NEAR(norm(arc_middle<Vec3>(a, -a, b, -b)), 1.0, 0.01 * std::pow(angle, 6));
    EXPECT_EQ(arc_middle<Vec3>(a, a, b, b), arc_middle(b, b, a, a));
}

TEST(ArcMiddle, IsTheChordsWhereNormalsSayNothing) {
    EXPECT_EQ(arc_middle<Vec3>({0, 0, 0}, {0, 0, 1}, {2, 0, 0}, {0, 0, 1}), (Vec3{1, 0, 0}));
    EXPECT_EQ(arc_middle<Vec3>({0, 0, 0}, {0, 0, 1}, {2, 0, 0}, {0, 0, -1}), (Vec3{1, 0, 0}));
}

}  // namespace
}  // namespace meniscus
