// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/ray_crossing.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

#include "grid/sampled_shapes.h"
#include "meniscus/errors.h"
#include "support/directions.h"
#include "support/level_sets.h"

namespace meniscus::testing {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

// The first crossing of the level set by many small steps along the ray, or infinity.
double plain_crossing(const LevelSet& level_set, const Vec3& origin, const Vec3& direction, double length) {
    const double step = level_set.spacing() / 50.0;
    double before = level_set.value(origin);
    for (double t = step; t < length; t += step) {
        const double here = level_set.value(origin + t * direction);
        if (!std::isnan(before) && !std::isnan(here) && (before < 0.0) != (here < 0.0)) return t;
        before = here;
    }
    return kNever;
}

TEST(RayCrossing, OfASphereIsInClosedForm) {
    const LevelSet level_set = spline_of(0.125, -kCorner, kCorner, kSphere);
    for (const Vec3& aim : random_points(300, 2.0)) {
        const Vec3 origin = 20.0 * normalised({aim.y, aim.z - 0.3, aim.x});
        const Vec3 direction = normalised(aim - origin);
        const double along = dot(kSphere.centre - origin, direction);
        const double off2 = squared_norm(kSphere.centre - origin) - along * along;
        const double half2 = kSphere.radius * kSphere.radius - off2;
        const double found = level_set.intersect(origin, direction);
        if (half2 > 1e-3) {
            EXPECT_NEAR(found, along - std::sqrt(half2), 1e-4);
        }
        if (half2 < -1e-3) {
            EXPECT_EQ(found, kNever);
        }
        if (std::isfinite(found)) {
            EXPECT_LT(std::abs(level_set.value(origin + found * direction)), 1e-7 * 0.125);
        }
    }
}

TEST(RayCrossing, InANarrowBandIsWhatSmallStepsFind) {
    const double h = 0.25;
    const Vec3 corner{4.5, 4.5, 1.5};
    const LevelSet level_set = narrow_spline_of(h, -corner, corner, kTorus, 2.0 * h);
    ASSERT_TRUE(std::isnan(level_set.value({0, 0, 6.0}))) << "the band should be narrow";
    int met = 0;
    for (const Vec3& aim : random_points(400, 3.0)) {
        const Vec3 origin = 3.0 * Vec3{aim.y, aim.z, aim.x};
        const Vec3 direction = normalised(aim - origin);
        const double found = level_set.intersect(origin, direction, 15.0);
        const double plain = plain_crossing(level_set, origin, direction, 15.0);
        if (std::isinf(plain)) {
            EXPECT_EQ(found, kNever);
        } else {
            EXPECT_NEAR(found, plain, h / 40.0);
            ++met;
        }
    }
    EXPECT_GT(met, 150);
}

TEST(RayCrossing, FromInsideIsTheWayOut) {
    const Sphere large{.centre = kSphere.centre, .radius = 4.0};
    const LevelSet level_set = narrow_spline_of(0.125, -kCorner, kCorner, large, 0.5);
    ASSERT_TRUE(std::isnan(level_set.value(large.centre)));
    for (const Vec3& direction : random_points(100, 1.0))
        EXPECT_NEAR(level_set.intersect(large.centre, direction), large.radius, 1e-4);
}

TEST(RayCrossing, AlongAxesAndThroughNodesAndEdges) {
    const Vec3 origin{0.5, 0.5, 0.5};  // a node
    const auto ball = [&](const Vec3& p) { return norm(p - origin) - 1.75; };
    const LevelSet level_set = spline_of(0.25, {-3, -3, -3}, {4, 4, 4}, ball);
    for (const Vec3& direction : directions_around()) {
        EXPECT_NEAR(level_set.intersect(origin, direction), 1.75, 1e-3);
        EXPECT_NEAR(level_set.intersect(origin + 10.0 * direction, -direction), 10.0 * norm(direction) - 1.75, 1e-3);
    }
}

TEST(RayCrossing, TwoThatAreAnEighthOfASpacingApartAreNotMissed) {
    const double h = 0.5;
    const auto slab = [&](const Vec3& p) { return (p.x - 0.1) * (p.x - 0.1) - std::pow(h / 15.9, 2); };
    const LevelSet level_set = spline_of(h, {-2, -2, -2}, {2, 2, 2}, slab);
    for (const Vec3& p : random_points(300, 1.5)) {
        const Vec3 origin{-1.9, p.y, p.z};
        const Vec3 direction = normalised({1.0, 0.2 * p.x, 0.1 * p.y});
        if (!(level_set.value(origin + (2.0 / direction.x) * direction) < 0.0)) continue;
        EXPECT_LT(level_set.intersect(origin, direction), 2.0 / direction.x);
    }
}

TEST(RayCrossing, LengthAndDirectionLimitIt) {
    const LevelSet level_set = spline_of(0.25, -kCorner, kCorner, kSphere);
    const Vec3 origin = kSphere.centre + Vec3{4.0, 0, 0};
    EXPECT_NEAR(level_set.intersect(origin, {-1, 0, 0}), 1.5, 1e-3);
    EXPECT_NEAR(level_set.intersect(origin, {-7, 0, 0}, 1.51), 1.5, 1e-3) << "the direction may have any length";
    EXPECT_EQ(level_set.intersect(origin, {-1, 0, 0}, 1.49), kNever);
    EXPECT_EQ(level_set.intersect(origin, {1, 0, 0}), kNever);
    EXPECT_EQ(level_set.intersect(origin, {-1, 0, 0}, -1.0), kNever);
    EXPECT_EQ(level_set.intersect({100, 100, 100}, {1, 0, 0}), kNever);
    EXPECT_EQ(level_set.intersect({100, 0, 0}, {0, 1, 0}), kNever);
}

TEST(RayCrossing, MovesWithTheOrigin) {
    const Vec3 far{40000.0, -30000.0, 20000.0};
    const Sphere moved{.centre = kSphere.centre + far, .radius = kSphere.radius};
    const LevelSet there = spline_of(0.25, far - kCorner, far + kCorner, moved);
    EXPECT_NEAR(there.intersect(moved.centre + Vec3{0, 30.0, 0}, {0, -1, 0}), 27.5, 1e-3);
}

// The same blocks at two places, 1.9e9 Å apart: nobody can go from block to block.
TEST(RayCrossing, GapsOfAnyLengthTakeNoTime) {
    constexpr std::int32_t kFar = 469'762'047;
    const LevelSet alone = rough_level_set(0.5);
    std::vector<BlockCoord> blocks(alone.grid().coords().begin(), alone.grid().coords().end());
    for (const BlockCoord& c : alone.grid().coords()) blocks.push_back({.z = c.z, .y = c.y, .x = c.x + kFar});
    const auto grid = std::make_shared<const BlockGrid>(0.5, alone.grid().origin(), blocks);
    std::vector<float> coefficients;
    for (const BlockCoord& c : grid->coords()) {
        const BlockId same = alone.grid().find({.z = c.z, .y = c.y, .x = c.x > 1 ? c.x - kFar : c.x});
        const auto values = alone.coefficients().subspan(std::size_t{same} * kBlockNodes, kBlockNodes);
        coefficients.insert(coefficients.end(), values.begin(), values.end());
    }
    const LevelSet both(grid, coefficients);
    const double apart = 0.5 * kBlockEdge * kFar;
    int met = 0;
    for (const Vec3& p : random_points(300, 3.0)) {
        const Vec3 direction = normalised({p.y, -p.z, p.x});
        const double found = alone.intersect(p, direction);
        if (std::isinf(found)) {
            EXPECT_EQ(both.intersect(p, direction), kNever);
        } else {
            EXPECT_NEAR(both.intersect(p, direction), found, 1e-6);
            ++met;
        }
        const double through_the_gap = alone.intersect({-10.0, p.y, p.z}, {1, 0, 0});
        if (std::isfinite(through_the_gap)) {
            EXPECT_NEAR(both.intersect({apart - 10.0, p.y, p.z}, {1, 0, 0}), through_the_gap, 1e-5);
            EXPECT_NEAR(both.intersect({10.0, p.y, p.z}, {1, 0, 0}), apart - 20.0 + through_the_gap, 1e-5);
        }
    }
    EXPECT_GT(met, 100);
}

TEST(RayCrossing, ManyRaysOfARoughLevelSetAllEnd) {
    const LevelSet level_set = rough_level_set(0.5);
    for (const Vec3& p : random_points(500, 6.0)) {
        const double found = level_set.intersect(p, {p.y, -p.z, p.x});
        if (std::isinf(found)) continue;
        const Vec3 at = p + found * normalised({p.y, -p.z, p.x});
        EXPECT_LT(std::abs(level_set.value(at)), 1e-6);
    }
}

TEST(RayCrossing, RaysThatAreNoneAreUsageErrors) {
    const LevelSet level_set = rough_level_set(0.5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(level_set.intersect({0, 0, 0}, {0, 0, 0}), UsageError);
    EXPECT_THROW(level_set.intersect({0, nan, 0}, {1, 0, 0}), UsageError);
    EXPECT_THROW(level_set.intersect({0, 0, 0}, {kNever, 0, 0}), UsageError);
    EXPECT_THROW(level_set.intersect({0, 0, 0}, {1, 0, 0}, nan), UsageError);
}

}  // namespace
}  // namespace meniscus::testing
