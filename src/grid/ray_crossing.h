// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where a ray first crosses the zero set of a spline on a block grid; see LevelSet::intersect.
#pragma once

#include <span>

#include "grid/block_grid.h"
#include "meniscus/vec3.h"

namespace meniscus {

struct Ray {
    Vec3 origin;          ///< Å
    Vec3 direction;       ///< unit vector
    double length = 0.0;  ///< Å, may be infinite
};

/// Corners of a box that holds all blocks of a grid, Å.
struct GridBounds {
    Vec3 low;
    Vec3 high;
};

/// Distance along the ray, Å, or infinity.
double first_crossing(const BlockGrid& grid, std::span<const float> coefficients, const GridBounds& bounds,
                      const Ray& ray);

}  // namespace meniscus
