// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/piece_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

std::size_t count_inside(const std::vector<DeepPoint>& points) {
    return static_cast<std::size_t>(
        std::count_if(points.begin(), points.end(), [](const DeepPoint& p) { return p.inside; }));
}

TEST(PiecePoints, AreOnTheSideTheySayAndAsDeep) {
    const AccessibleSurface surface(hollow_shell(60, 5.2, 1.7), 1.4);
    const std::vector<DeepPoint> points = piece_points(surface);
    for (const DeepPoint& point : points) {
        const double depth = surface.nearest(point.position).signed_distance;
        EXPECT_EQ(depth < 0.0, point.inside);
        EXPECT_GE(std::abs(depth), point.radius - 1e-6);
    }
    EXPECT_GE(count_inside(points), 1U);
    const auto in_the_void = [](const DeepPoint& p) { return !p.inside && norm(p.position) < 3.0; };
    EXPECT_TRUE(std::any_of(points.begin(), points.end(), in_the_void));
}

TEST(PiecePoints, EveryAtomApartHasOne) {
    const Atoms atoms{{{0, 0, 0}, {1.2, 0, 0}, {20, 0, 0}}, {1.7, 1.52, 1.8}};
    const std::vector<DeepPoint> points = piece_points(AccessibleSurface(atoms, 1.4));
    EXPECT_EQ(count_inside(points), 2U);  // the two that overlap are one piece
    EXPECT_EQ(count_inside(piece_points(AccessibleSurface(Atoms{{{1, 2, 3}}, {0.5}}, 1.4))), 1U);
}

}  // namespace
}  // namespace meniscus::testing
