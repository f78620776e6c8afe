// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The level-set function: a tri-cubic B-spline on a narrow band whose zero set is the surface.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "meniscus/curvature.h"
#include "meniscus/node_field.h"
#include "meniscus/vec3.h"

namespace meniscus {

class BlockGrid;

/// Value and derivatives of a level-set function at one point, and the curvatures of the level set through it.
///
/// Curvatures follow from gradient and Hessian whatever the slope of Φ; they are NaN where the gradient is zero.
struct LevelSetSample {
    double value = 0.0;  ///< Φ, Å; negative inside
    Vec3 gradient;       ///< ∇Φ
    /// Second derivatives in the order xx, yy, zz, xy, xz, yz, Å^-1.
    double hessian[6] = {0, 0, 0, 0, 0, 0};

    double mean_curvature() const;                     ///< half the sum of the principal ones, Å^-1
    double gaussian_curvature() const;                 ///< their product, Å^-2
    PrincipalCurvatures principal_curvatures() const;  ///< Å^-1
    double shape_index() const;                        ///< see PrincipalCurvatures
};

/// A twice continuously differentiable function on the narrow band (Pan & Tai 2009, eq. 2.1).
///
/// Outside the band, which ends one node before its outermost nodes, every query returns NaN. Queries of many points
/// run in parallel and give the same as one by one, in the order of the points.
class LevelSet {
public:
    /// Takes the spline coefficients, one per node of the grid. Copies them where they are no NodeField.
    LevelSet(std::shared_ptr<const BlockGrid> grid, NodeField coefficients);
    template <class Floats>
    LevelSet(std::shared_ptr<const BlockGrid> grid, const Floats& coefficients)
        : LevelSet(std::move(grid), NodeField(coefficients.begin(), coefficients.end())) {}

    double spacing() const;
    double value(const Vec3& point) const;
    LevelSetSample sample(const Vec3& point) const;

    std::vector<double> values(std::span<const Vec3> points) const;
    std::vector<Vec3> gradients(std::span<const Vec3> points) const;
    std::vector<LevelSetSample> samples(std::span<const Vec3> points) const;

    /// The point of the zero set reached from `point` along the gradient, or `point` itself where Newton's
    /// iteration leaves a ball of one spacing around it.
    Vec3 project(const Vec3& point) const;

    /// The point of the zero set that is closest to `point`, by Newton's method on the conditions for a minimum of the
    /// distance, from `point` on or from a point `start` near the surface.
    ///
    /// What is returned has |Φ| below 1e-7 spacings times its slope, and the line to `point` is normal to the surface
    /// there up to 1e-6 spacings. It is the closest point where that is unique and Φ is near to a distance; where
    /// several are about equally close (next to a medial axis) it is a local minimum of the distance, one of them. From
    /// `point` on, starts around it are tried where the first one fails. NaN in all coordinates outside the band, and
    /// where no such point was found within kReach spacings.
    /// cost     three or four samples, about 0.5 µs; some 10 µs where the first start fails
    Vec3 closest_point(const Vec3& point) const;
    Vec3 closest_point(const Vec3& point, const Vec3& start) const;
    std::vector<Vec3> closest_points(std::span<const Vec3> points) const;

    static constexpr double kReach = 10.0;  ///< of closest_point, in spacings

    /// Distance along a ray to the first crossing of the zero set, from either side; infinity if there is none.
    ///
    /// origin     Å; anywhere, outside the band too
    /// direction  of any length but zero
    /// length     of the ray, Å
    /// returns  Å, exact to 1e-7 spacings. A pair of crossings less than 1/8 spacing apart can be missed, no other: in
    ///          cells whose spline coefficients do not all have one sign the ray is sampled that closely, in others
    ///          the spline has no zero. An origin on the zero set counts as outside.
    /// throws   UsageError for an origin or direction that is not finite, a zero direction, a length that is NaN
    /// cost     a few µs; blocks of 8³ nodes that are missing are stepped over
    double intersect(const Vec3& origin, const Vec3& direction,
                     double length = std::numeric_limits<double>::infinity()) const;

    const BlockGrid& grid() const { return *grid_; }
    std::span<const float> coefficients() const { return coefficients_; }

private:
    std::shared_ptr<const BlockGrid> grid_;
    NodeField coefficients_;
    Vec3 low_;  // corners of the box round all blocks
    Vec3 high_;
};

}  // namespace meniscus
