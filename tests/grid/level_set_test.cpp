// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/level_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "grid/sampled_shapes.h"
#include "support/level_sets.h"

namespace meniscus::testing {
namespace {

// Random points that lie on the zero set of f, a distance.
template <class Function>
std::vector<Vec3> points_on(const Function& f) {
    constexpr double kStep = 1e-6;
    std::vector<Vec3> points;
    for (Vec3 p : random_points(1000, 4.4)) {
        if (std::abs(f(p)) > 0.8) continue;
        for (int i = 0; i < 3; ++i) {
            const auto slope = [&](const Vec3& d) { return (f(p + d) - f(p - d)) / (2 * kStep); };
            p = p - f(p) * Vec3{slope({kStep, 0, 0}), slope({0, kStep, 0}), slope({0, 0, kStep})};
        }
        points.push_back(p);
    }
    return points;
}

std::array<double, 10> numbers(const LevelSetSample& s) {
    return {s.value,      s.gradient.x, s.gradient.y, s.gradient.z, s.hessian[0],
            s.hessian[1], s.hessian[2], s.hessian[3], s.hessian[4], s.hessian[5]};
}

Vec3 axis_step(int axis, double length) {
    return {axis == 0 ? length : 0.0, axis == 1 ? length : 0.0, axis == 2 ? length : 0.0};
}

// p with one coordinate taken from q.
Vec3 on_border(const Vec3& p, int axis, const Vec3& q) {
    return {axis == 0 ? q.x : p.x, axis == 1 ? q.y : p.y, axis == 2 ? q.z : p.z};
}

// Largest errors at points of the sphere or torus, whose principal curvatures `exact` knows.
struct CurvatureErrors {
    double mean = 0.0;
    double gaussian = 0.0;
    double shape_index = 0.0;
};

template <class Function, class Curvature>
CurvatureErrors curvature_errors(double spacing, const Function& f, const Curvature& exact) {
    const LevelSet spline = spline_of(spacing, -kCorner, kCorner, f);
    CurvatureErrors worst;
    for (const Vec3& p : points_on(f)) {
        const LevelSetSample at = spline.sample(p);
        const PrincipalCurvatures k = exact(p);
        worst.mean = std::max(worst.mean, std::abs(at.mean_curvature() - k.mean()));
        worst.gaussian = std::max(worst.gaussian, std::abs(at.gaussian_curvature() - k.gaussian()));
        worst.shape_index = std::max(worst.shape_index, std::abs(at.shape_index() - k.shape_index()));
    }
    return worst;
}

template <class Function>
double value_error(double spacing, const Function& f) {
    const LevelSet spline = spline_of(spacing, -kCorner, kCorner, f);
    double worst = 0.0;
    for (const Vec3& p : points_on(f)) worst = std::max(worst, std::abs(spline.value(p)));
    return worst;
}

TEST(LevelSet, APlaneHasItsGradientAndNoCurvature) {
    const Vec3 normal = normalised({1, -2, 0.5});
    const LevelSet spline =
        spline_of(0.5, {-3, -3, -3}, {3, 3, 3}, [&](const Vec3& p) { return dot(normal, p) - 0.4; });
    for (const Vec3& p : random_points(200, 3.0)) {
        const LevelSetSample at = spline.sample(p);
        EXPECT_NEAR(at.value, dot(normal, p) - 0.4, 2e-6);
        EXPECT_NEAR(norm(at.gradient - normal), 0.0, 1e-5);
        EXPECT_NEAR(at.mean_curvature(), 0.0, 2e-5);
        EXPECT_EQ(spline.value(p), at.value);
    }
}

TEST(LevelSet, DerivativesAreThoseOfTheValue) {
    const double h = 0.5;
    const LevelSet spline = rough_level_set(h);
    constexpr double kStep = 1e-5;
    for (const Vec3& p : random_points(300, 2.0)) {
        const LevelSetSample at = spline.sample(p);
        std::array<Vec3, 3> slopes;
        std::array<double, 3> slope{};
        for (int axis = 0; axis < 3; ++axis) {
            const LevelSetSample before = spline.sample(p - axis_step(axis, kStep));
            const LevelSetSample after = spline.sample(p + axis_step(axis, kStep));
            const auto i = static_cast<std::size_t>(axis);
            slope[i] = (after.value - before.value) / (2 * kStep);
            slopes[i] = (0.5 / kStep) * (after.gradient - before.gradient);
        }
        EXPECT_NEAR(norm(at.gradient - Vec3{slope[0], slope[1], slope[2]}), 0.0, 1e-7);
        EXPECT_NEAR(norm(slopes[0] - Vec3{at.hessian[0], at.hessian[3], at.hessian[4]}), 0.0, 2e-3);
        EXPECT_NEAR(norm(slopes[1] - Vec3{at.hessian[3], at.hessian[1], at.hessian[5]}), 0.0, 2e-3);
        EXPECT_NEAR(norm(slopes[2] - Vec3{at.hessian[4], at.hessian[5], at.hessian[2]}), 0.0, 2e-3);
    }
}

TEST(LevelSet, IsTwiceContinuouslyDifferentiableAcrossCellsAndBlocks) {
    const double h = 0.5;
    const LevelSet spline = rough_level_set(h);
    const Vec3 origin = spline.grid().origin();
    constexpr double kStep = 1e-9;
    for (const Vec3& p : random_points(40, 2.0))
        for (int axis = 0; axis < 3; ++axis)
            for (int cell = -4; cell <= 12; ++cell) {  // borders of blocks at 0 and 8
                const Vec3 border = on_border(p, axis, origin + h * cell * Vec3{1, 1, 1});
                const auto before = numbers(spline.sample(border - axis_step(axis, kStep)));
                const auto after = numbers(spline.sample(border + axis_step(axis, kStep)));
                for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(before[i], after[i], 1e-6);
            }
}

TEST(LevelSet, SphereIsApproachedWithFourthOrderAndItsCurvaturesWithSecond) {
    const auto curvature = [](const Vec3&) { return PrincipalCurvatures{1.0 / kSphere.radius, 1.0 / kSphere.radius}; };
    EXPECT_GT(std::log2(value_error(0.5, kSphere) / value_error(0.25, kSphere)), 3.5);
    const CurvatureErrors coarse = curvature_errors(0.5, kSphere, curvature);
    const CurvatureErrors fine = curvature_errors(0.25, kSphere, curvature);
    EXPECT_GT(std::log2(coarse.mean / fine.mean), 1.8);
    EXPECT_GT(std::log2(coarse.gaussian / fine.gaussian), 1.8);
    EXPECT_LT(fine.mean, 0.005);
    EXPECT_LT(fine.gaussian, 0.005);
    EXPECT_LT(fine.shape_index, 0.02);
}

TEST(LevelSet, TorusIsApproachedWithFourthOrderAndItsCurvaturesWithSecond) {
    const auto curvature = [](const Vec3& p) {
        const double from_axis = std::hypot(p.x, p.y);
        return PrincipalCurvatures{1.0 / kTorus.minor, (from_axis - kTorus.major) / (kTorus.minor * from_axis)};
    };
    EXPECT_GT(std::log2(value_error(0.3, kTorus) / value_error(0.15, kTorus)), 3.2);
    const CurvatureErrors coarse = curvature_errors(0.3, kTorus, curvature);
    const CurvatureErrors fine = curvature_errors(0.15, kTorus, curvature);
    EXPECT_GT(std::log2(coarse.mean / fine.mean), 1.8);
    EXPECT_GT(std::log2(coarse.gaussian / fine.gaussian), 1.8);
    EXPECT_LT(fine.mean, 0.02);
    EXPECT_LT(fine.gaussian, 0.02);
    EXPECT_LT(fine.shape_index, 0.05);
}

TEST(LevelSet, ManyPointsGiveTheSameAsOneByOne) {
    const LevelSet spline = spline_of(0.25, -kCorner, kCorner, kTorus);
    const std::vector<Vec3> points = random_points(3000, 6.5);  // some outside the band
    const std::vector<double> values = spline.values(points);
    const std::vector<Vec3> gradients = spline.gradients(points);
    const std::vector<LevelSetSample> samples = spline.samples(points);
    const std::vector<Vec3> feet = spline.closest_points(points);
    ASSERT_EQ(feet.size(), points.size());
    int outside = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const LevelSetSample one = spline.sample(points[i]);
        outside += std::isnan(one.value) ? 1 : 0;
        if (std::isnan(one.value)) {
            EXPECT_TRUE(std::isnan(values[i]) && std::isnan(gradients[i].y) && std::isnan(samples[i].hessian[3]));
            EXPECT_TRUE(std::isnan(feet[i].x));
            continue;
        }
        EXPECT_EQ(values[i], one.value);
        EXPECT_EQ(gradients[i], one.gradient);
        EXPECT_EQ(numbers(samples[i]), numbers(one));
        const Vec3 foot = spline.closest_point(points[i]);
        EXPECT_TRUE(feet[i] == foot || std::isnan(foot.x));
    }
    EXPECT_GT(outside, 100);
}

TEST(LevelSet, IsNotANumberOutsideTheBand) {
    const LevelSet spline = rough_level_set(0.5);  // nodes from -8 to 15 along each axis
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    const Vec3 origin = spline.grid().origin();
    const auto node = [&](double i) { return origin + 0.5 * Vec3{i, 1.0, 1.0}; };
    EXPECT_FALSE(std::isnan(spline.value(node(-6.999))));
    EXPECT_TRUE(std::isnan(spline.value(node(-7.001))));
    EXPECT_FALSE(std::isnan(spline.value(node(13.999))));
    EXPECT_TRUE(std::isnan(spline.value(node(14.001))));
    for (const double far : {100.0, -1e6, 1e15, kNan, kInfinity, -kInfinity}) {
        const LevelSetSample at = spline.sample({far, 0.0, 0.0});
        for (const double number : numbers(at)) EXPECT_TRUE(std::isnan(number));
        EXPECT_TRUE(std::isnan(at.mean_curvature()));
        EXPECT_TRUE(std::isnan(at.gaussian_curvature()));
        EXPECT_TRUE(std::isnan(at.shape_index()));
    }
}

TEST(LevelSet, ProjectLandsOnTheZeroSet) {
    const double h = 0.25;
    const LevelSet spline = spline_of(h, -kCorner, kCorner, kSphere);
    for (Vec3 p : points_on(kSphere)) {
        p += 0.6 * h * normalised({p.y, p.z, p.x});
        const Vec3 landed = spline.project(p);
        EXPECT_NEAR(spline.value(landed), 0.0, 1e-7 * h);
        EXPECT_LT(norm(landed - p), h);
        EXPECT_NEAR(kSphere(landed), 0.0, 1e-3);
    }
}

TEST(LevelSet, ProjectLeavesPointsThatAreTooFar) {
    const LevelSet spline = spline_of(0.25, -kCorner, kCorner, kSphere);
    const Vec3 centre = kSphere.centre;
    for (const Vec3 p : {centre + Vec3{0.5, 0, 0}, centre + Vec3{0, 3.0, 0}, Vec3{1e6, 0, 0}})
        EXPECT_EQ(spline.project(p), p);
}

TEST(LevelSet, SamplesMoveWithTheOrigin) {
    const Vec3 far{40000.0, -30000.0, 20000.0};
    const Sphere moved{.centre = kSphere.centre + far, .radius = kSphere.radius};
    const LevelSet here = spline_of(0.5, -kCorner, kCorner, kSphere);
    const LevelSet there = spline_of(0.5, far - kCorner, far + kCorner, moved);
    for (const Vec3& p : random_points(200, 4.0)) EXPECT_NEAR(here.value(p), there.value(p + far), 1e-5);
}

TEST(LevelSetSample, MeanCurvatureIsThatOfTheLevelSet) {
    // Φ = x² + y²: the cylinder through (2, 0, 0) has H = 1/(2·2), whatever the slope of Φ.
    const LevelSetSample cylinder{4.0, {4.0, 0.0, 0.0}, {2.0, 2.0, 0.0, 0.0, 0.0, 0.0}};
    EXPECT_NEAR(cylinder.mean_curvature(), 0.25, 1e-15);
    // Φ = -(x² + y² + z²): the outside is negative, so the sphere of radius 2 is hollow.
    const LevelSetSample hollow{-4.0, {0.0, 0.0, -4.0}, {-2.0, -2.0, -2.0, 0.0, 0.0, 0.0}};
    EXPECT_NEAR(hollow.mean_curvature(), -0.5, 1e-15);
    // Φ = xy at (1, 1): a saddle-shaped hyperbola with curvature |1/√2|, here bending away from the negative side.
    const LevelSetSample mixed{1.0, {1.0, 1.0, 0.0}, {0.0, 0.0, 0.0, 1.0, 0.0, 0.0}};
    EXPECT_NEAR(mixed.mean_curvature(), -0.5 / std::sqrt(2.0), 1e-15);
}

TEST(LevelSetSample, PrincipalCurvaturesAreThoseOfTheLevelSet) {
    const LevelSetSample cylinder{4.0, {4.0, 0.0, 0.0}, {2.0, 2.0, 0.0, 0.0, 0.0, 0.0}};
    EXPECT_EQ(cylinder.gaussian_curvature(), 0.0);
    EXPECT_NEAR(cylinder.principal_curvatures().largest, 0.5, 1e-15);
    EXPECT_NEAR(cylinder.shape_index(), 0.5, 1e-15);
    const LevelSetSample hollow{-4.0, {0.0, 0.0, -4.0}, {-2.0, -2.0, -2.0, 0.0, 0.0, 0.0}};
    EXPECT_NEAR(hollow.gaussian_curvature(), 0.25, 1e-15);
    EXPECT_NEAR(hollow.shape_index(), -1.0, 1e-15);
    // Φ = z - x y / 2 at the origin: a saddle with curvatures ±1/2 along the diagonals.
    const LevelSetSample saddle{0.0, {0.0, 0.0, 1.0}, {0.0, 0.0, 0.0, -0.5, 0.0, 0.0}};
    EXPECT_NEAR(saddle.gaussian_curvature(), -0.25, 1e-15);
    EXPECT_NEAR(saddle.principal_curvatures().smallest, -0.5, 1e-15);
    EXPECT_EQ(saddle.shape_index(), 0.0);
}

TEST(LevelSetSample, CurvaturesDoNotDependOnTheFrame) {
    // Φ = k1 u² / 2 + k2 v² / 2 + w with (u, v, w) an oblique orthonormal frame, scaled by 3.
    const Vec3 w = normalised({1, -2, 0.5});
    const Vec3 u = normalised(cross(w, {0, 0, 1}));
    const Vec3 v = cross(w, u);
    const double k1 = 0.8;
    const double k2 = -0.3;
    const auto second = [&](double Vec3::*a, double Vec3::*b) { return 3.0 * (k1 * u.*a * u.*b + k2 * v.*a * v.*b); };
    const auto x = &Vec3::x;
    const auto y = &Vec3::y;
    const auto z = &Vec3::z;
    const LevelSetSample at{
        0.0, 3.0 * w, {second(x, x), second(y, y), second(z, z), second(x, y), second(x, z), second(y, z)}};
    EXPECT_NEAR(at.mean_curvature(), 0.5 * (k1 + k2), 1e-14);
    EXPECT_NEAR(at.gaussian_curvature(), k1 * k2, 1e-14);
    EXPECT_NEAR(at.principal_curvatures().largest, k1, 1e-14);
    EXPECT_NEAR(at.principal_curvatures().smallest, k2, 1e-14);
}

}  // namespace
}  // namespace meniscus::testing
