// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The level-set function, whose zero set is the surface: a tri-cubic B-spline on a narrow band.
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
/// Curvatures follow from gradient and Hessian, whatever the slope of Φ, and are positive on a sphere. They are NaN
/// where the gradient is zero.
struct LevelSetSample {
    double value = 0.0;  ///< Φ, Å; negative inside
    Vec3 gradient;       ///< ∇Φ, without unit
    /// Second derivatives in the order xx, yy, zz, xy, xz, yz, Å^-1.
    double hessian[6] = {0, 0, 0, 0, 0, 0};

    double mean_curvature() const;                     ///< half the sum of the principal curvatures, Å^-1
    double gaussian_curvature() const;                 ///< product of the principal curvatures, Å^-2
    PrincipalCurvatures principal_curvatures() const;  ///< Å^-1
    double shape_index() const;                        ///< -1 to 1; see PrincipalCurvatures
};

/// A level-set function, twice continuously differentiable on the narrow band (Pan & Tai 2009, eq. 2.1). Points in Å.
///
/// Outside the band, which ends one spacing within its outermost nodes, values and derivatives are NaN. Queries of many
/// points run in parallel; results are in the order of the points and the same as one by one.
class LevelSet {
public:
    /// Takes the spline coefficients, one per node of the grid, in the order of its blocks. A NodeField is not copied.
    LevelSet(std::shared_ptr<const BlockGrid> grid, NodeField coefficients);
    template <class Floats>
    LevelSet(std::shared_ptr<const BlockGrid> grid, const Floats& coefficients)
        : LevelSet(std::move(grid), NodeField(coefficients.begin(), coefficients.end())) {}

    double spacing() const;                 ///< Å
    double value(const Vec3& point) const;  ///< Φ, Å; negative inside
    LevelSetSample sample(const Vec3& point) const;

    std::vector<double> values(std::span<const Vec3> points) const;
    std::vector<Vec3> gradients(std::span<const Vec3> points) const;
    std::vector<LevelSetSample> samples(std::span<const Vec3> points) const;

    /// The point of the zero set that Newton's iteration reaches from `point` along the gradient, or `point` itself if
    /// the iteration goes farther than one spacing.
    Vec3 project(const Vec3& point) const;

    /// The point of the zero set that is closest to `point`, by Newton's method on the conditions for a minimum of the
    /// distance. The iteration starts at `start`, a point near the surface; without one it starts at `point` and, if
    /// that fails, around it.
    ///
    /// The result has |Φ| below 1e-7 spacings times |∇Φ|, and the line to `point` is normal to the surface there up to
    /// 1e-6 spacings. Next to a medial axis, where several points are about equally close, it is one of them: a local
    /// minimum of the distance. All coordinates are NaN outside the band and where nothing is found within kReach.
    ///
    /// cost     three or four samples, about 0.5 µs; some 10 µs where the first start fails
    Vec3 closest_point(const Vec3& point) const;
    Vec3 closest_point(const Vec3& point, const Vec3& start) const;
    std::vector<Vec3> closest_points(std::span<const Vec3> points) const;

    static constexpr double kReach = 10.0;  ///< farthest that closest_point() looks, spacings

    /// Distance along a ray to its first crossing of the zero set, from either side, Å; infinity if there is none.
    ///
    /// The distance is exact to 1e-7 spacings. Only a pair of crossings less than 1/8 spacing apart can be missed: the
    /// ray is sampled that closely in cells whose spline coefficients differ in sign; in others the spline has no zero.
    /// An origin on the zero set counts as outside.
    ///
    /// origin     Å; anywhere, also outside the band
    /// direction  of any length but zero
    /// length     length of the ray, Å
    /// throws     UsageError for an origin or direction that is not finite, a zero direction, a length that is NaN
    /// cost       a few µs; blocks of 8³ nodes that the grid does not have are stepped over
    double intersect(const Vec3& origin, const Vec3& direction,
                     double length = std::numeric_limits<double>::infinity()) const;

    const BlockGrid& grid() const { return *grid_; }
    std::span<const float> coefficients() const { return coefficients_; }

private:
    std::shared_ptr<const BlockGrid> grid_;
    NodeField coefficients_;
    Vec3 low_;  // corners of the bounding box of all blocks, Å
    Vec3 high_;
};

}  // namespace meniscus
