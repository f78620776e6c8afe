// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/creases.h"

#include <gtest/gtest.h>

#include <cmath>

namespace meniscus {
namespace {

constexpr double kSlope = 0x1.d21708p-2 / 0x1.c7e36p-1;  // 0.511: single precision holds its unit normals to 1e-14

// Half a roof whose ridge runs over the middles of two sides.
Mesh half_roof(float mean_curvature) {
    const Vec3 left = normalised({-kSlope, 0, 1});
    const Vec3 right = normalised({kSlope, 0, 1});
    Mesh mesh;
    mesh.vertices = {{-0.3, 0, 0}, {0.3, 0, 0}, {-0.3, 0.3, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {to_small(left), to_small(right), to_small(left)};
    mesh.mean_curvatures.assign(3, mean_curvature);
    mesh.gaussian_curvatures.assign(3, 0.0F);
    return mesh;
}

TEST(Creases, PartsFollowTheRoof) {
    const Mesh mesh = half_roof(0.0F);
    const auto parts = parts_over_crease(mesh, mesh.triangles[0], {});
    ASSERT_TRUE(parts);
    EXPECT_NEAR(parts->two_areas, 0.18 * std::hypot(1.0, kSlope), 1e-12);
    EXPECT_GT(parts->six_volumes, 0.0);
}

TEST(Creases, AreNotWhereCurvaturesExplainTheTurn) {
    const Mesh mesh = half_roof(0.6F);  // principal curvatures 1.2 and 0 Å^-1
    EXPECT_FALSE(parts_over_crease(mesh, mesh.triangles[0], {}));
}

TEST(Creases, OfTheOtherSenseAreNotExplainedByThem) {
    Mesh mesh = half_roof(0.6F);
    for (SmallVec3& normal : mesh.normals) normal.x = -normal.x;  // a valley
    const auto parts = parts_over_crease(mesh, mesh.triangles[0], {});
    ASSERT_TRUE(parts);
    EXPECT_NEAR(parts->two_areas, 0.18 * std::hypot(1.0, kSlope), 1e-12);
}

TEST(Creases, AreKnownOnlyWithCurvatures) {
    Mesh mesh = half_roof(0.0F);
    EXPECT_TRUE(knows_creases(mesh));
    mesh.gaussian_curvatures.clear();
    EXPECT_FALSE(knows_creases(mesh));
}

}  // namespace
}  // namespace meniscus
