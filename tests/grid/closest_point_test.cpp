// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/closest_point.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "grid/sampled_shapes.h"
#include "support/level_sets.h"

namespace meniscus::testing {
namespace {

// Random points within some distance of the zero set of f.
template <class Function>
std::vector<Vec3> points_near(const Function& f, double reach) {
    std::vector<Vec3> points = random_points(4000, 4.4);
    std::erase_if(points, [&](const Vec3& p) { return std::abs(f(p)) > reach; });
    return points;
}

// What closest_point promises of the foot, whatever the level set.
void expect_foot(const LevelSet& level_set, const Vec3& point, const Vec3& foot) {
    const double h = level_set.spacing();
    const LevelSetSample at = level_set.sample(foot);
    const Vec3 normal = normalised(at.gradient);
    const Vec3 line = point - foot;
    EXPECT_LT(std::abs(at.value) / norm(at.gradient), 1.01e-7 * h);
    EXPECT_LT(norm(line - dot(line, normal) * normal), 1.01e-6 * h);
}

// Largest error of the distance to the foot, in spacings.
template <class Function>
double distance_error(const LevelSet& level_set, const Function& f, double reach) {
    double worst = 0.0;
    for (const Vec3& p : points_near(f, reach)) {
        const Vec3 foot = level_set.closest_point(p);
        expect_foot(level_set, p, foot);
        worst = std::max(worst, std::abs(norm(foot - p) - std::abs(f(p))));
    }
    return worst / level_set.spacing();
}

TEST(ClosestPoint, OfASphereIsTheDistanceToIt) {
    const double h = 0.125;
    EXPECT_LT(distance_error(spline_of(h, -kCorner, kCorner, kSphere), kSphere, 3.0 * h), 1e-4);
}

TEST(ClosestPoint, OfATorusIsTheDistanceToIt) {
    const double h = 0.1;
    EXPECT_LT(distance_error(spline_of(h, -kCorner, kCorner, kTorus), kTorus, 3.0 * h), 2e-4);
}

TEST(ClosestPoint, IsNotWhereTheGradientLeads) {
    // Φ = x² / a² + y² / b² + z² / c² - 1: gradients do not lead to the closest points of an ellipsoid.
    const auto ellipsoid = [](const Vec3& p) { return p.x * p.x / 9.0 + p.y * p.y / 4.0 + p.z * p.z / 2.25 - 1.0; };
    const LevelSet level_set = spline_of(0.25, -kCorner, kCorner, ellipsoid);
    double farthest = 0.0;
    for (const Vec3& p : random_points(3000, 3.2)) {
        if (std::abs(ellipsoid(p)) > 0.5) continue;
        const Vec3 foot = level_set.closest_point(p);
        expect_foot(level_set, p, foot);
        farthest = std::max(farthest, norm(foot - level_set.project(p)));
        // x_i (1 + λ / a_i²) = p_i with one λ: the closest point in closed form.
        const double lambda = (p.x / foot.x - 1.0) * 9.0;
        if (std::abs(foot.x) > 0.3 && std::abs(foot.y) > 0.3) {
            EXPECT_NEAR(lambda, (p.y / foot.y - 1.0) * 4.0, 1e-3);
        }
    }
    EXPECT_GT(farthest, 0.1) << "the points should be hard ones";
}

TEST(ClosestPoint, WhereManyAreEquallyCloseIsOneOfThem) {
    const LevelSet level_set = spline_of(0.3, -kCorner, kCorner, kSphere);
    const Vec3 beside = kSphere.centre + Vec3{1e-3, 2e-3, -1e-3};
    EXPECT_NEAR(norm(level_set.closest_point(beside) - kSphere.centre), kSphere.radius, 0.01);
}

TEST(ClosestPoint, OnASlabsMiddlePlaneIsOnEitherSide) {
    const double h = 0.25;
    for (const double half : {1.2 * h, 2.0 * h, 3.3 * h}) {
        const auto slab = [&](const Vec3& p) { return std::abs(p.z - 0.013) - half; };
        const LevelSet level_set = spline_of(h, {-2, -2, -2}, {2, 2, 2}, slab);
        for (Vec3 p : random_points(200, 1.0)) {
            p.z = 0.013;
            const Vec3 foot = level_set.closest_point(p);
            expect_foot(level_set, p, foot);
            EXPECT_NEAR(norm(foot - p), half, 0.1 * h);
        }
    }
}

TEST(ClosestPoint, AStartChoosesAmongThem) {
    const auto slab = [&](const Vec3& p) { return std::abs(p.z) - 1.0; };
    const LevelSet level_set = spline_of(0.25, {-2, -2, -2}, {2, 2, 2}, slab);
    const Vec3 point{0.3, 0.4, 0.1};
    EXPECT_NEAR(level_set.closest_point(point).z, 1.0, 1e-3);
    EXPECT_NEAR(level_set.closest_point(point, {0.5, 0.2, -0.9}).z, -1.0, 1e-3);
    EXPECT_NEAR(level_set.closest_point(point, {0.5, 0.2, -0.9}).x, 0.3, 1e-5);
}

TEST(ClosestPoint, OnTheSurfaceIsThePointItself) {
    const LevelSet level_set = spline_of(0.25, -kCorner, kCorner, kSphere);
    for (const Vec3& p : points_near(kSphere, 0.2)) {
        const Vec3 foot = level_set.closest_point(p);
        EXPECT_LT(norm(level_set.closest_point(foot) - foot), 2e-7 * 0.25);
    }
}

TEST(ClosestPoint, IsNotANumberOutsideTheBandOrFarFromTheSurface) {
    const LevelSet level_set = spline_of(0.125, -kCorner, kCorner, kSphere);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Vec3 p : {Vec3{100, 0, 0}, Vec3{nan, 0, 0}, kSphere.centre + Vec3{0, 4.0, 0}}) {
        EXPECT_TRUE(std::isnan(level_set.closest_point(p).x));
        EXPECT_TRUE(std::isnan(level_set.closest_point(p, kSphere.centre + Vec3{2.5, 0, 0}).x));
    }
}

TEST(ClosestPoint, OfARoughLevelSetKeepsItsPromiseOrSaysNothing) {
    const LevelSet level_set = rough_level_set(0.5);
    int found = 0;
    for (const Vec3& p : random_points(2000, 3.0)) {
        const Vec3 foot = level_set.closest_point(p);
        if (std::isnan(foot.x)) continue;
        expect_foot(level_set, p, foot);
        ++found;
    }
    EXPECT_GT(found, 1800);
}

}  // namespace
}  // namespace meniscus::testing
