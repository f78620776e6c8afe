// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "volume_files.h"

namespace meniscus::testing {
namespace {

constexpr VolumeGrid kGrid{{5, 4, 6}, {-1.0, 2.0, 0.5}, {0.5, 0.25, 0.75}};

std::vector<Vec3> points_in(const VolumeGrid& grid, std::size_t count) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    const Vec3 size = grid.node(grid.counts[0] - 1, grid.counts[1] - 1, grid.counts[2] - 1) - grid.origin;
    std::vector<Vec3> points(count);
    for (Vec3& p : points)
        p = grid.origin + Vec3{share(random) * size.x, share(random) * size.y, share(random) * size.z};
    return points;
}

template <class Function>
void expect_exact(const Function& function, Interpolation interpolation) {
    const Volume volume = volume_of(kGrid, function);
    const std::vector<Vec3> points = points_in(kGrid, 500);
    const std::vector<double> values = interpolate(volume, points, interpolation);
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(values[i], function(points[i]), 3e-6);
}

double line(const Vec3& p) { return 1.0 + 2.0 * p.x - 0.5 * p.y + 0.25 * p.z; }
double parabola(const Vec3& p) { return p.x * p.x - 2.0 * p.y * p.z + 0.5 * p.z * p.z + line(p); }

TEST(Interpolate, IsExactForLinearFunctions) {
    expect_exact(line, Interpolation::Linear);
    expect_exact(line, Interpolation::Cubic);
}

TEST(Interpolate, CubicIsExactForQuadraticFunctionsUpToTheFaces) { expect_exact(parabola, Interpolation::Cubic); }

TEST(Interpolate, GoesThroughTheNodes) {
    const Volume volume = volume_of(kGrid, [](const Vec3& p) { return std::sin(7.0 * p.x + p.y) + p.z; });
    for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::Cubic})
        for (std::size_t i = 0; i < kGrid.counts[0]; ++i)
            for (std::size_t k = 0; k < kGrid.counts[2]; ++k) {
                const std::vector<Vec3> node{kGrid.node(i, 3, k)};
                EXPECT_NEAR(interpolate(volume, node, interpolation)[0], volume.values[kGrid.index(i, 3, k)], 1e-6);
            }
}

TEST(Interpolate, IsNotANumberOutside) {
    const Volume volume = volume_of(kGrid, line);
    const Vec3 last = kGrid.node(4, 3, 5);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<Vec3> outside{kGrid.origin - Vec3{1e-9, 0, 0},
                                    last + Vec3{0, 0, 1e-9},
                                    {nan, 2.1, 1.0},
                                    {0.0, std::numeric_limits<double>::infinity(), 1.0}};
    const std::vector<Vec3> on_it{kGrid.origin, last, {0.0, 2.0, 1.0}};
    for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::Cubic}) {
        for (const double value : interpolate(volume, outside, interpolation)) EXPECT_TRUE(std::isnan(value));
        for (const double value : interpolate(volume, on_it, interpolation)) EXPECT_TRUE(std::isfinite(value));
    }
}

TEST(Interpolate, TakesGridsOfOneAndTwoNodes) {
    const VolumeGrid flat{{1, 2, 2}, {}, {1, 1, 1}};
    const Volume volume = volume_of(flat, [](const Vec3& p) { return p.y + 10.0 * p.z; });
    const std::vector<Vec3> points{{0.0, 0.5, 0.25}, {0.1, 0.5, 0.25}};
    for (const Interpolation interpolation : {Interpolation::Linear, Interpolation::Cubic}) {
        const std::vector<double> values = interpolate(volume, points, interpolation);
        EXPECT_NEAR(values[0], 3.0, 1e-6);
        EXPECT_TRUE(std::isnan(values[1]));
    }
}

TEST(Interpolate, ErrorsFallWithTheirOrder) {
    const auto wave = [](const Vec3& p) { return std::sin(p.x) * std::cos(p.y + p.z); };
    const auto error = [&](std::size_t n, Interpolation interpolation) {
        const double h = std::numbers::pi / static_cast<double>(n - 1);
        const VolumeGrid grid{{n, n, n}, {}, {h, h, h}};
        const std::vector<Vec3> points = points_in(grid, 2000);
        const std::vector<double> values = interpolate(volume_of(grid, wave), points, interpolation);
        double most = 0.0;
        for (std::size_t i = 0; i < points.size(); ++i) most = std::max(most, std::abs(values[i] - wave(points[i])));
        return most;
    };
    EXPECT_GT(error(9, Interpolation::Linear), 3.0 * error(17, Interpolation::Linear));  // order 2
    EXPECT_GT(error(9, Interpolation::Cubic), 6.0 * error(17, Interpolation::Cubic));    // order 3
}

TEST(Interpolate, RefusesAVolumeThatDoesNotMatchItsGrid) {
    Volume volume = volume_of(kGrid, line);
    volume.values.pop_back();
    EXPECT_THROW(interpolate(volume, std::vector<Vec3>{{0, 0, 0}}), UsageError);
}

}  // namespace
}  // namespace meniscus::testing
