// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/patch_integrals.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/perpendicular.h"

namespace meniscus {
namespace {

// A tilted arc away from the origin.
SasArc some_arc(double radius, double height0, double height1, double angle) {
    SasArc arc;
    arc.axis = normalised({1, 2, 2});
    const Vec3 e1 = perpendicular(arc.axis);
    arc.middle = std::cos(0.3) * e1 + std::sin(0.3) * cross(arc.axis, e1);
    arc.centre = {0.4, -1.2, 2.0};
    arc.radius = radius;
    arc.height0 = height0;
    arc.height1 = height1;
    arc.angle = angle;
    arc.cos_half = std::cos(0.5 * angle);
    if (angle < 2 * std::numbers::pi) arc.start = arc.end = 0;
    return arc;
}

// The same integrals by the midpoint rule.
PatchIntegrals by_quadrature(const SasArc& arc, double probe, const ToroidalPatch::Range& range) {
    constexpr int kSteps = 600;
    const Vec3 beside = cross(arc.axis, arc.middle);
    const double dt = arc.angle / kSteps;
    const double dp = (range.end.psi - range.begin.psi) / kSteps;
    PatchIntegrals sum;
    for (int i = 0; i < kSteps; ++i) {
        const double theta = -0.5 * arc.angle + (i + 0.5) * dt;
        const Vec3 e = std::cos(theta) * arc.middle + std::sin(theta) * beside;
        for (int j = 0; j < kSteps; ++j) {
            const double psi = range.begin.psi + (j + 0.5) * dp;
            const Vec3 n = std::cos(psi) * e - std::sin(psi) * arc.axis;
            const Vec3 x = arc.centre + arc.radius * e - probe * n;
            const double da = (arc.radius - probe * std::cos(psi)) * probe * dt * dp;
            sum += {da, dot(x, n) * da / 3.0, da * x};
        }
    }
    return sum;
}

TEST(PatchIntegrals, ATorusIsDividedAtThePlaneOfItsCircle) {
    for (const SasArc& arc : {some_arc(2.5, 1.5, 1.0, 1.3), some_arc(1.1, 2.9, 2.7, 4.0), some_arc(2.0, -0.5, 2.4, 2.0),
                              some_arc(2.0, 2.4, -0.5, 2.0)}) {
        const ToroidalPatch torus = toroidal_patch(arc, 1.4);
        for (int k = 0; k < torus.count; ++k) {
            ToroidalPatch::Range at_first = torus.pieces[k];
            at_first.begin.psi = std::min(at_first.begin.psi, 0.0);
            at_first.end.psi = std::min(at_first.end.psi, 0.0);
            EXPECT_NEAR(toroidal_area_at_first(arc, 1.4, torus.pieces[k]), by_quadrature(arc, 1.4, at_first).area,
                        1e-4);
        }
    }
}

TEST(PatchIntegrals, ToroidalPieceAgreesWithQuadrature) {
    for (const SasArc& arc :
         {some_arc(2.5, 1.5, 1.0, 1.3), some_arc(2.5, 1.5, 1.0, 2 * std::numbers::pi), some_arc(1.1, 2.9, 2.7, 4.0),
          some_arc(2.0, -0.5, 2.4, 2.0), some_arc(1.0, -0.9, 2.9, 0.4)}) {
        const ToroidalPatch torus = toroidal_patch(arc, 1.4);
        for (int k = 0; k < torus.count; ++k) {
            const PatchIntegrals exact = toroidal_piece(arc, 1.4, torus.pieces[k], arc.centre);
            const PatchIntegrals sum = by_quadrature(arc, 1.4, torus.pieces[k]);
            EXPECT_GT(exact.area, 0.0);
            EXPECT_NEAR(exact.area, sum.area, 1e-4 * sum.area);
            EXPECT_NEAR(exact.volume, sum.volume, 1e-4 * sum.area);
            EXPECT_NEAR(norm(exact.first_moment - sum.first_moment), 0.0, 1e-4 * sum.area);
        }
    }
}

TEST(PatchIntegrals, ATorusThatMeetsItsAxisFallsIntoTwo) {
    EXPECT_EQ(toroidal_patch(some_arc(1.0, 2.9, 2.9, 2 * std::numbers::pi), 1.4).count, 2);
    EXPECT_EQ(toroidal_patch(some_arc(1.5, 2.9, 2.9, 2 * std::numbers::pi), 1.4).count, 1);
    EXPECT_EQ(toroidal_patch(some_arc(1.0, -2.9, 3.9, 2 * std::numbers::pi), 1.4).count, 1)
        << "its circle is beyond one atom";
}

TEST(PatchIntegrals, SphereEnclosesItsVolume) {
    const SphericalRegion whole{4 * std::numbers::pi, {}};
    const PatchIntegrals outside = sphere_patch({1, 2, 3}, 2.0, whole, 1);
    EXPECT_NEAR(outside.area, 16 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(outside.volume, 32.0 / 3.0 * std::numbers::pi, 1e-12);
    EXPECT_NEAR(norm((1.0 / outside.area) * outside.first_moment - Vec3{1, 2, 3}), 0.0, 1e-12);
    EXPECT_NEAR(sphere_patch({1, 2, 3}, 2.0, whole, -1).volume, -32.0 / 3.0 * std::numbers::pi, 1e-12);
}

}  // namespace
}  // namespace meniscus
