// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/surface_projector.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meniscus::testing {
namespace {

// Three balls that meet in a corner: of points within them, a whole cone is nearest to it.
const Atoms kTripod{{{0.61, 0.013, -0.8}, {-0.36, 0.48, -0.81}, {0.02, -0.6, -0.79}}, {1.0, 1.02, 0.98}};

TEST(SurfaceProjector, NormalsAreUnitVectorsAlsoInCorners) {
    const AccessibleSurface exact(kTripod, 0.0);
    const SurfaceProjector project = surface_projector(exact, nullptr, 0.5, Curvatures::FilledIn);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 1000; ++i) {
        const double angle = 2.4 * i;
        const double out = 0.0002 * i;
        points.emplace_back().position = {out * std::cos(angle), out * std::sin(angle), -0.1 - 0.0001 * i};
    }
    int in_corners = 0;
    for (int times = 0; times < 2; ++times) {
        project(points);
        for (const SurfacePoint& point : points) {
            const NearestFeature at = exact.nearest(point.position);
            EXPECT_NEAR(norm(point.normal), 1.0, 1e-6);
            EXPECT_NEAR(at.signed_distance, 0.0, 1e-8);
            EXPECT_TRUE(std::isfinite(point.curvature));
            in_corners += at.patch != PatchKind::Contact ? 1 : 0;
        }
    }
    EXPECT_GT(in_corners, 0) << "no point has come to lie in a corner";
}

// Mended vertices are projected once more when all is known about them: what moved then would be bad again.
TEST(SurfaceProjector, StepsThatFallShortNextToRidgesAreTakenUntilTheyDoNot) {
    const AccessibleSurface exact(Atoms{{{0.0, 0.0, 0.0}, {5.3, 0.0, 0.0}, {2.6, 4.7, 0.0}}, {1.7, 1.6, 1.5}}, 1.4);
    const SurfaceProjector project = surface_projector(exact, nullptr, 0.5, Curvatures::FilledIn);
    std::vector<SurfacePoint> points;
    for (int i = 0; i < 20000; ++i) {
        const Vec3 anywhere{std::fmod(0.7548776662 * i, 1.0), std::fmod(0.5698402910 * i, 1.0),
                            std::fmod(0.3183098862 * i, 1.0)};
        const Vec3 point{9.0 * anywhere.x - 2.0, 9.0 * anywhere.y - 2.0, 4.0 * anywhere.z - 2.0};
        if (std::abs(exact.nearest(point).signed_distance) < 0.5) points.emplace_back().position = point;
    }
    ASSERT_GT(points.size(), 2000U);
    project(points);
    double farthest = 0.0;
    for (const SurfacePoint& point : points)
        farthest = std::max(farthest, std::abs(exact.nearest(point.position).signed_distance));
    EXPECT_LE(farthest, 0.005);  // after four steps 0.35
}

}  // namespace
}  // namespace meniscus::testing
