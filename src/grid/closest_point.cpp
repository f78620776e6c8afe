// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/closest_point.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace meniscus {
namespace {

constexpr int kMaxSteps = 24;
constexpr int kFullSteps = 8;             // from then on half steps, which leave cycles of Newton's method
constexpr double kLastStep = 1e-4;        // in spacings: quadratic convergence leaves the square of it
constexpr double kOnSurface = 1e-7;       // in spacings
constexpr double kStationary = 1e-6;      // in spacings, between the foot and the normal through the point
constexpr double kLeastStiffness = 1e-3;  // of the distance along the surface, whose stiffness is 1 on a plane
constexpr double kNoStiffness = -0.02;    // below this the distance falls along the surface: not a minimum
constexpr double kOverreach = 1.5;        // steps are no longer than so many |Φ| and a spacing

constexpr int kRunsAround = 4;

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr Vec3 kNowhere{kNan, kNan, kNan};

Vec3 hessian_times(const LevelSetSample& at, const Vec3& v) {
    const auto& [xx, yy, zz, xy, xz, yz] = at.hessian;
    return {xx * v.x + xy * v.y + xz * v.z, xy * v.x + yy * v.y + yz * v.z, xz * v.x + yz * v.y + zz * v.z};
}

Vec3 across(const Vec3& n) {
    const Vec3 axis = std::abs(n.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    return normalised(cross(n, axis));
}

struct Step {
    Vec3 move;
    bool is_newton = false;      // not changed for the sake of descent
    bool is_minimum = false;     // the distance does not fall to second order along the surface
    bool is_stationary = false;  // there is no need to move
};

// Newton's step for x - p + λ ∇Φ = 0, Φ = 0 at a point x with d = p - x: the normal part makes Φ vanish, the tangential
// part solves (1 + λ Hessian) t = d - (1 + λ Hessian) normal part in the tangent plane. Where that matrix, the
// stiffness of the distance, is not positive enough it is shifted until it is, so that the step goes downhill.
Step newton_step(const LevelSetSample& at, const Vec3& d, double spacing) {
    const double slope = norm(at.gradient);
    const Vec3 n = (1.0 / slope) * at.gradient;
    const double multiplier = dot(d, n) / slope;
    const auto stiffness_times = [&](const Vec3& v) { return v + multiplier * hessian_times(at, v); };
    const Vec3 normal_part = (-at.value / slope) * n;
    const Vec3 pull = d - stiffness_times(normal_part);
    const Vec3 e1 = across(n);
    const Vec3 e2 = cross(n, e1);
    const Vec3 w1 = stiffness_times(e1);
    const double a11 = dot(e1, w1);
    const double a12 = dot(e2, w1);
    const double a22 = dot(e2, stiffness_times(e2));
    const double half_difference = 0.5 * (a11 - a22);
    const double least = 0.5 * (a11 + a22) - std::sqrt(half_difference * half_difference + a12 * a12);
    const double shift = std::max(0.0, kLeastStiffness - least);
    const double b1 = dot(e1, pull);
    const double b2 = dot(e2, pull);
    const double determinant = (a11 + shift) * (a22 + shift) - a12 * a12;
    const double t1 = ((a22 + shift) * b1 - a12 * b2) / determinant;
    const double t2 = ((a11 + shift) * b2 - a12 * b1) / determinant;
    return {
        .move = normal_part + t1 * e1 + t2 * e2,
        .is_newton = shift == 0.0,
        .is_minimum = least > kNoStiffness,
        .is_stationary = norm(normal_part) < kOnSurface * spacing && norm(d - dot(d, n) * n) < kStationary * spacing};
}

// One run of Newton's method; nothing where it ends at no minimum, leaves the band or does not end.
std::optional<Vec3> search(SplineCursor& cursor, const Vec3& point, const Vec3& start, double spacing) {
    Vec3 at = start;
    if (!cursor.move_to(at)) return std::nullopt;
    for (int i = 0; i < kMaxSteps; ++i) {
        const LevelSetSample here = cursor.sample();
        if (!(squared_norm(here.gradient) > 0.0)) return std::nullopt;
        const Step step = newton_step(here, point - at, spacing);
        if (step.is_stationary) return step.is_minimum ? std::optional(at) : std::nullopt;
        const double length = norm(step.move);
        const double longest = kOverreach * std::abs(here.value) + spacing;
        const double damping = i < kFullSteps ? 1.0 : 0.5;
        at = at + (length > longest ? longest / length : damping) * step.move;
        if (!(norm(at - point) < LevelSet::kReach * spacing) || !cursor.move_to(at)) return std::nullopt;
        if (step.is_newton && damping == 1.0 && length < kLastStep * spacing) return at;
    }
    return std::nullopt;
}

// A place to start from, and |Φ| there.
struct Start {
    double distance = 0.0;
    Vec3 at;
    bool operator<(const Start& other) const { return distance < other.distance; }
};

// Places round the point, as far from it as the surface should be, nearest to the surface first.
std::vector<Start> starts_around(SplineCursor& cursor, const Vec3& point, double spacing) {
    const double radius = std::max(cursor.move_to(point) ? std::abs(cursor.value()) : 0.0, 0.5 * spacing);
    std::vector<Start> starts;
    for (const double z : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 1.0})
            for (const double x : {-1.0, 0.0, 1.0}) {
                if (x == 0.0 && y == 0.0 && z == 0.0) continue;
                const Vec3 at = point + radius * normalised({x, y, z});
                if (cursor.move_to(at)) starts.push_back({std::abs(cursor.value()), at});
            }
    std::stable_sort(starts.begin(), starts.end());
    return starts;
}

// The best of the first few runs round the point that get somewhere.
Vec3 search_around(SplineCursor& cursor, const Vec3& point, double spacing) {
    Vec3 best = kNowhere;
    double least = std::numeric_limits<double>::infinity();
    int runs_left = kRunsAround;
    for (const Start& start : starts_around(cursor, point, spacing)) {
        const std::optional<Vec3> found = search(cursor, point, start.at, spacing);
        if (!found) continue;
        if (const double distance = norm(*found - point); distance < least) {
            best = *found;
            least = distance;
        }
        if (--runs_left == 0) break;
    }
    return best;
}

}  // namespace

Vec3 closest_point(SplineCursor& cursor, const Vec3& point, double spacing) {
    if (!cursor.move_to(point)) return kNowhere;
    if (const auto found = search(cursor, point, point, spacing)) return *found;
    return search_around(cursor, point, spacing);
}

Vec3 closest_point_from(SplineCursor& cursor, const Vec3& point, const Vec3& start, double spacing) {
    if (!is_finite(point)) return kNowhere;
    return search(cursor, point, start, spacing).value_or(kNowhere);
}

}  // namespace meniscus
