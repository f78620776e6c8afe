// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/paper/printed_curvature.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

#include "support/arrangements.h"
#include "support/sampled_field.h"

namespace meniscus::testing {
namespace {

constexpr double kWaterProbe = 1.4;
constexpr double kSpacing = 0.5;

// Two spheres on the x axis: the torus touches the sphere of radius r at height x = r (d/2) / (r + R).
void expect_formulas(double distance, BridgedPair bridged, double waist_curvature) {
    const double r = 1.7;
    const AccessibleSurface surface(two_spheres(distance, r, r), kWaterProbe);
    const auto zero = [](const Vec3&) { return 0.0; };
    const SampledField field = sample_box(kSpacing, {-4, -4, -4}, {distance + 4, 4, 4}, zero);
    const NodeField found = sample_printed_curvature(surface, field.grid, bridged);
    const double circle = std::sqrt((r + kWaterProbe) * (r + kWaterProbe) - 0.25 * distance * distance);
    int waists = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
        const NearestFeature at = surface.nearest(field.grid.position(n));
        const Vec3 p = field.grid.position(n);
        if (at.patch == PatchKind::Contact) {
            ASSERT_NEAR(found[n], 1.0 / r, 1e-6);
            continue;
        }
        const double from_axis = std::hypot(p.y, p.z);
        const double to_circle = std::hypot(p.x - 0.5 * distance, circle - from_axis);
        const double d = std::abs(circle - kWaterProbe * (circle - from_axis) / to_circle);
        const double torus = std::min(0.5 * (1.0 / d - 1.0 / kWaterProbe), 1.0 / kSpacing);
        ASSERT_NEAR(found[n], std::isnan(waist_curvature) ? torus : waist_curvature, 1e-5);
        ++waists;
    }
    EXPECT_GT(waists, 10);
}

TEST(PrintedCurvature, IsConstantAlongNormalsAndWithoutCosine) {
    expect_formulas(2.4, BridgedPair::Torus, std::nan(""));
    expect_formulas(4.5, BridgedPair::Torus, std::nan(""));
    expect_formulas(2.4, BridgedPair::Reentrant, std::nan(""));  // they intersect: no matter
}

TEST(PrintedCurvature, ALiteralReadingTakesBridgedPairsForReentrant) {
    expect_formulas(4.5, BridgedPair::Reentrant, -1.0 / kWaterProbe);
}

TEST(PrintedCurvature, IsThatOfTheProbeOnReentrantPatches) {
    const AccessibleSurface surface(tetrahedral_spheres(3.0, 1.5), kWaterProbe);
    const auto zero = [](const Vec3&) { return 0.0; };
    const SampledField field = sample_box(kSpacing, {-4, -4, -4}, {4, 4, 4}, zero);
    const NodeField found = sample_printed_curvature(surface, field.grid, BridgedPair::Torus);
    int reentrant = 0;
    for (std::size_t n = 0; n < found.size(); ++n) {
        if (surface.nearest(field.grid.position(n)).patch != PatchKind::Reentrant) continue;
        ASSERT_NEAR(found[n], -1.0 / kWaterProbe, 1e-6);
        ++reentrant;
    }
    EXPECT_GT(reentrant, 10);
}

}  // namespace
}  // namespace meniscus::testing
