// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The level-set function: a tri-cubic B-spline on a narrow band whose zero set is the surface.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus {

class BlockGrid;

/// Value and derivatives of a level-set function at one point.
struct LevelSetSample {
    double value = 0.0;  ///< Φ, Å; negative inside
    Vec3 gradient;       ///< ∇Φ
    /// Second derivatives in the order xx, yy, zz, xy, xz, yz, Å^-1.
    double hessian[6] = {0, 0, 0, 0, 0, 0};

    /// Mean curvature of the level set through the point, Å^-1; positive on a sphere.
    double mean_curvature() const;
};

/// A twice continuously differentiable function on the narrow band (Pan & Tai 2009, eq. 2.1).
///
/// Outside the band every query returns NaN.
class LevelSet {
public:
    /// Takes the spline coefficients, one per node of the grid.
    LevelSet(std::shared_ptr<const BlockGrid> grid, std::vector<float> coefficients);

    double spacing() const;
    double value(const Vec3& point) const;
    LevelSetSample sample(const Vec3& point) const;

    /// The point of the zero set reached from `point` along the gradient, or `point` itself where Newton's
    /// iteration leaves a ball of one spacing around it.
    Vec3 project(const Vec3& point) const;

    const BlockGrid& grid() const { return *grid_; }
    std::span<const float> coefficients() const { return coefficients_; }

private:
    std::shared_ptr<const BlockGrid> grid_;
    std::vector<float> coefficients_;
};

}  // namespace meniscus
