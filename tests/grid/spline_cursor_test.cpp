// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_cursor.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "support/level_sets.h"

namespace meniscus::testing {
namespace {

// The cubic B-spline with support (-2, 2).
double b_spline(double t) {
    const double a = std::abs(t);
    if (a >= 2.0) return 0.0;
    return a >= 1.0 ? (2.0 - a) * (2.0 - a) * (2.0 - a) / 6.0 : (4.0 - 6.0 * a * a + 3.0 * a * a * a) / 6.0;
}

// The sum over all nodes, without any cells.
double plain_value(const LevelSet& level_set, const Vec3& p) {
    const BlockGrid& grid = level_set.grid();
    double sum = 0.0;
    for (BlockId b = 0; b < grid.block_count(); ++b)
        for (int node = 0; node < kBlockNodes; ++node) {
            const Vec3 at = node_position(grid, b, node % 8, node / 8 % 8, node / 64);
            const Vec3 u = (1.0 / grid.spacing()) * (p - at);
            sum += level_set.coefficients()[std::size_t{b} * kBlockNodes + static_cast<std::size_t>(node)] *
                   b_spline(u.x) * b_spline(u.y) * b_spline(u.z);
        }
    return sum;
}

TEST(SplineCursor, ValueIsTheSumOverAllNodes) {
    const LevelSet level_set = rough_level_set(0.5);
    SplineCursor cursor(level_set.grid(), level_set.coefficients());
    for (const Vec3& p : random_points(60, 3.0)) {
        ASSERT_TRUE(cursor.move_to(p));
        EXPECT_NEAR(cursor.value(), plain_value(level_set, p), 1e-13);
        EXPECT_EQ(cursor.value(), cursor.sample().value);
    }
}

TEST(SplineCursor, FirstDerivativesAloneHaveTheBitsOfTheSample) {
    const LevelSet level_set = rough_level_set(0.5);
    SplineCursor cursor(level_set.grid(), level_set.coefficients());
    for (const Vec3& p : random_points(60, 3.0)) {
        ASSERT_TRUE(cursor.move_to(p));
        const ValueAndGradient first_order = cursor.value_and_gradient();
        EXPECT_EQ(first_order.value, cursor.sample().value);
        EXPECT_EQ(first_order.gradient, cursor.sample().gradient);
    }
}

TEST(SplineCursor, AProjectionHasTheSampleOfItsPoint) {
    const LevelSet level_set = rough_level_set(0.5);
    SplineCursor cursor(level_set.grid(), level_set.coefficients());
    int stayed = 0;
    for (const Vec3& p : random_points(300, 5.0)) {  // some outside the band, some too far from the zero set
        const auto [point, at] = project_to_zero_set(cursor, p, level_set.spacing());
        EXPECT_EQ(point, level_set.project(p));
        const LevelSetSample sample = level_set.sample(point);
        if (std::isnan(sample.value)) {
            EXPECT_EQ(point, p);
            EXPECT_TRUE(std::isnan(at.value) && std::isnan(at.gradient.x) && std::isnan(at.hessian[5]));
            continue;
        }
        stayed += point == p ? 1 : 0;
        EXPECT_EQ(at.value, sample.value);
        EXPECT_EQ(at.gradient, sample.gradient);
        for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(at.hessian[i], sample.hessian[i]);
    }
    EXPECT_GT(stayed, 20);
}

TEST(SplineCursor, WhereItHasBeenDoesNotMatter) {
    const LevelSet level_set = rough_level_set(0.5);
    SplineCursor cursor(level_set.grid(), level_set.coefficients());
    for (const Vec3& p : random_points(200, 4.5)) {
        const bool inside = cursor.move_to(p);
        EXPECT_EQ(inside, !std::isnan(level_set.value(p)));
        if (inside) {
            EXPECT_EQ(cursor.value(), level_set.value(p));
        }
        EXPECT_FALSE(cursor.move_to({1e3, 0.0, 0.0}));
    }
}

TEST(SplineCursor, PlacesInACellAreCountedFromItsLowerNode) {
    const LevelSet level_set = rough_level_set(0.5);
    SplineCursor cursor(level_set.grid(), level_set.coefficients());
    ASSERT_TRUE(cursor.move_to_cell({-1, 3, 7}));
    cursor.move_within({0.25, 0.5, 1.0});
    const Vec3 at = level_set.grid().origin() + 0.5 * Vec3{-0.75, 3.5, 8.0};
    EXPECT_NEAR(cursor.value(), level_set.value(at), 1e-14);
    EXPECT_FALSE(cursor.move_to_cell({-8, 0, 0})) << "no node before the first of the band";
}

TEST(SplineCursor, SignIsThatOfEveryPointOfTheCell) {
    const LevelSet level_set = spline_of(0.5, {-3, -3, -3}, {3, 3, 3}, [](const Vec3& p) { return norm(p) - 2.5; });
    SplineCursor cursor(level_set.grid(), level_set.coefficients());
    int seen[3] = {0, 0, 0};
    for (const Vec3& p : random_points(2000, 3.0)) {
        ASSERT_TRUE(cursor.move_to(p));
        ++seen[cursor.sign() + 1];
        if (cursor.sign() != 0) {
            EXPECT_GT(cursor.value() * cursor.sign(), 0.0);
        }
    }
    for (const int count : seen) EXPECT_GT(count, 20);
}

}  // namespace
}  // namespace meniscus::testing
