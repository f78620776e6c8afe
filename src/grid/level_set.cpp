// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/level_set.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "grid/block_grid.h"
#include "grid/closest_point.h"
#include "grid/ray_crossing.h"
#include "grid/spline_cursor.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kPointsPerChunk = 256;

LevelSetSample sample_at(SplineCursor& cursor, const Vec3& point) {
    return cursor.move_to(point) ? cursor.sample() : nowhere();
}

// query(cursor, point) of every point, in parallel; neighbours in the list share a cursor.
template <class T, class Query>
std::vector<T> of_all(const LevelSet& level_set, std::span<const Vec3> points, const Query& query) {
    std::vector<T> results(points.size());
    parallel_chunks(points.size(), kPointsPerChunk, [&](std::size_t begin, std::size_t end) {
        SplineCursor cursor(level_set.grid(), level_set.coefficients());
        for (std::size_t i = begin; i < end; ++i) results[i] = query(cursor, points[i]);
    });
    return results;
}

#include "grid/implicit_curvature.inc"

ImplicitDerivatives<double> derivatives_of(const LevelSetSample& at) {
    const auto& [xx, yy, zz, xy, xz, yz] = at.hessian;
    return {at.gradient.x, at.gradient.y, at.gradient.z, xx, yy, zz, xy, xz, yz};
}

}  // namespace

double LevelSetSample::mean_curvature() const { return derivatives_of(*this).mean_curvature(norm(gradient)); }

double LevelSetSample::gaussian_curvature() const { return derivatives_of(*this).gaussian_curvature(); }

PrincipalCurvatures LevelSetSample::principal_curvatures() const {
    return meniscus::principal_curvatures(mean_curvature(), gaussian_curvature());
}

double LevelSetSample::shape_index() const { return principal_curvatures().shape_index(); }

LevelSet::LevelSet(std::shared_ptr<const BlockGrid> grid, NodeField coefficients)
    : grid_(std::move(grid)), coefficients_(std::move(coefficients)) {
    if (grid_->block_count() == 0) return;
    BlockCoord low = grid_->coord(0);
    BlockCoord high = low;
    for (const BlockCoord& c : grid_->coords()) {
        low = {.z = std::min(low.z, c.z), .y = std::min(low.y, c.y), .x = std::min(low.x, c.x)};
        high = {.z = std::max(high.z, c.z), .y = std::max(high.y, c.y), .x = std::max(high.x, c.x)};
    }
    low_ = grid_->corner(low);
    high_ = grid_->corner({.z = high.z + 1, .y = high.y + 1, .x = high.x + 1});
}

double LevelSet::spacing() const { return grid_->spacing(); }

double LevelSet::value(const Vec3& point) const {
    SplineCursor cursor(*grid_, coefficients_);
    return cursor.move_to(point) ? cursor.value() : kUndefined;
}

LevelSetSample LevelSet::sample(const Vec3& point) const {
    SplineCursor cursor(*grid_, coefficients_);
    return sample_at(cursor, point);
}

std::vector<double> LevelSet::values(std::span<const Vec3> points) const {
    return of_all<double>(*this, points, [](SplineCursor& cursor, const Vec3& point) {
        return cursor.move_to(point) ? cursor.value() : kUndefined;
    });
}

std::vector<Vec3> LevelSet::gradients(std::span<const Vec3> points) const {
    return of_all<Vec3>(*this, points,
                        [](SplineCursor& cursor, const Vec3& point) { return sample_at(cursor, point).gradient; });
}

std::vector<LevelSetSample> LevelSet::samples(std::span<const Vec3> points) const {
    return of_all<LevelSetSample>(*this, points, sample_at);
}

Vec3 LevelSet::project(const Vec3& point) const {
    SplineCursor cursor(*grid_, coefficients_);
    return project_to_zero_set(cursor, point, spacing()).point;
}

Vec3 LevelSet::closest_point(const Vec3& point) const {
    SplineCursor cursor(*grid_, coefficients_);
    return meniscus::closest_point(cursor, point, spacing());
}

Vec3 LevelSet::closest_point(const Vec3& point, const Vec3& start) const {
    SplineCursor cursor(*grid_, coefficients_);
    return meniscus::closest_point_from(cursor, point, start, spacing());
}

std::vector<Vec3> LevelSet::closest_points(std::span<const Vec3> points) const {
    return of_all<Vec3>(*this, points, [h = spacing()](SplineCursor& cursor, const Vec3& point) {
        return meniscus::closest_point(cursor, point, h);
    });
}

double LevelSet::intersect(const Vec3& origin, const Vec3& direction, double length) const {
    if (!is_finite(origin) || !is_finite(direction) || !(norm(direction) > 0.0) || std::isnan(length))
        throw UsageError("a ray needs a finite origin, a finite direction that is not zero, and a length");
    return first_crossing(*grid_, coefficients_, {low_, high_}, {origin, normalised(direction), length});
}

}  // namespace meniscus
