// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Level sets and points to try them at, for tests.
#pragma once

#include <cstddef>
#include <memory>
#include <random>
#include <utility>
#include <vector>

#include "support/spline_of.h"

namespace meniscus::testing {

/// Points of the cube [-extent, extent]³, always the same.
inline std::vector<Vec3> random_points(std::size_t count, double extent) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> within(-extent, extent);
    std::vector<Vec3> points(count);
    for (Vec3& p : points) p = {within(random), within(random), within(random)};
    return points;
}

/// Coefficients without any smoothness, on blocks around the origin.
inline LevelSet rough_level_set(double spacing) {
    BlockGrid grid(spacing, {0.07, 0.03, -0.01}, box_of_blocks({.z = -1, .y = -1, .x = -1}, {.z = 1, .y = 1, .x = 1}));
    std::mt19937_64 random(4);
    std::uniform_real_distribution<float> value(-1.0F, 1.0F);
    NodeField coefficients(grid.node_count());
    for (float& c : coefficients) c = value(random);
    return {std::make_shared<const BlockGrid>(std::move(grid)), std::move(coefficients)};
}

/// The spline of a distance on the blocks with a node within half_width of its zero set, and those around them. `low`
/// and `high` are corners of a box round the zero set.
template <class Function>
LevelSet narrow_spline_of(double spacing, const Vec3& low, const Vec3& high, const Function& f, double half_width) {
    const Vec3 rim = (half_width + 4.0 * spacing) * Vec3{1, 1, 1};
    const SampledField field = narrow_band(sample_box(spacing, low - rim, high + rim, f), half_width);
    const LevelSet whole = spline_of(spacing, low - rim, high + rim, f);
    NodeField coefficients;
    for (const BlockCoord& c : field.grid.coords()) {
        const auto first =
            whole.coefficients().begin() + static_cast<std::ptrdiff_t>(std::size_t{whole.grid().find(c)} * kBlockNodes);
        coefficients.insert(coefficients.end(), first, first + kBlockNodes);
    }
    return {std::make_shared<const BlockGrid>(field.grid), std::move(coefficients)};
}

}  // namespace meniscus::testing
