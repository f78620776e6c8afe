// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_block.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "support/level_sets.h"

namespace meniscus::testing {
namespace {

constexpr double kSpacing = 0.5;

constexpr double kRadius = 5.5;

LevelSet ball() {
    return spline_of(kSpacing, {-7, -7, -7}, {7, 7, 7}, [](const Vec3& p) { return norm(p) - kRadius; });
}

// Where vertices start: on the edges of the grid that the ball cuts, one block after the other.
std::vector<Vec3> points_on_edges(const LevelSet& level_set) {
    const BlockGrid& grid = level_set.grid();
    std::vector<Vec3> points;
    for (std::size_t n = 0; n < grid.node_count(); ++n)
        for (const Vec3& step : {Vec3{kSpacing, 0, 0}, Vec3{0, kSpacing, 0}, Vec3{0, 0, kSpacing}}) {
            const Vec3 low = grid.position(n);
            const double a = norm(low) - kRadius;
            const double b = norm(low + step) - kRadius;
            if (a * b < 0.0) points.push_back(low + (a / (a - b)) * step);
        }
    return points;
}

std::vector<SplineProjection> project(const LevelSet& level_set, std::span<const Vec3> points,
                                      const SplineKernels& kernels) {
    std::vector<SplineProjection> projections(points.size());
    SplineBlock(level_set.grid(), level_set.coefficients(), kernels).project(points, projections);
    return projections;
}

void expect_same(const SplineProjection& found, const SplineProjection& expected) {
    EXPECT_EQ(found.point, expected.point);
    EXPECT_EQ(found.sample.value, expected.sample.value);
    EXPECT_EQ(found.sample.gradient, expected.sample.gradient);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(found.sample.hessian[i], expected.sample.hessian[i]);
}

TEST(SplineBlock, PointsEndWhereTheCursorSays) {
    const LevelSet level_set = ball();
    const std::vector<Vec3> points = points_on_edges(level_set);
    ASSERT_GT(points.size(), 1000U);
    const std::vector<SplineProjection> projections = project(level_set, points, spline_kernels());
    SplineCursor cursor(level_set.grid(), level_set.coefficients());
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_LE(std::abs(projections[i].sample.value), 1e-7 * kSpacing);
        expect_same(projections[i], project_to_zero_set(cursor, points[i], kSpacing));
    }
}

TEST(SplineBlock, EveryInstructionSetGivesTheSameBits) {
    const LevelSet level_set = ball();
    const std::vector<Vec3> points = points_on_edges(level_set);
    const std::vector<SplineKernels> all = supported_spline_kernels();
    const std::vector<SplineProjection> plain = project(level_set, points, all.front());
    for (const SplineKernels& kernels : all) {
        const std::vector<SplineProjection> projections = project(level_set, points, kernels);
        for (std::size_t i = 0; i < points.size(); ++i) {
            SCOPED_TRACE(kernels.instructions);
            expect_same(projections[i], plain[i]);
        }
    }
}

// Far points, points outside the band and those that leave the block go the long way.
TEST(SplineBlock, PointsThatGoAstrayEndWhereTheCursorSays) {
    const LevelSet level_set = rough_level_set(kSpacing);
    std::vector<Vec3> points = random_points(400, 5.0);
    const BlockGrid& grid = level_set.grid();
    const auto block_of = [&](const Vec3& p) {
        const Vec3 at = (1.0 / (kBlockEdge * kSpacing)) * (p - grid.origin());
        return std::array<double, 3>{std::floor(at.z), std::floor(at.y), std::floor(at.x)};
    };
    std::ranges::sort(points, {}, block_of);
    const std::vector<SplineProjection> projections = project(level_set, points, spline_kernels());
    SplineCursor cursor(grid, level_set.coefficients());
    std::size_t failed = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const SplineProjection expected = project_to_zero_set(cursor, points[i], kSpacing);
        if (expected.point != points[i]) {
            expect_same(projections[i], expected);
            continue;
        }
        ++failed;  // did not arrive: it left the ball, or the band
        const LevelSetSample& at = projections[i].sample;
        EXPECT_TRUE(projections[i].point == points[i] || std::abs(at.value) <= 1e-7 * kSpacing);
    }
    EXPECT_GT(failed, 20U);
    EXPECT_LT(failed, points.size() - 20);
}

}  // namespace
}  // namespace meniscus::testing
