// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// One side of a plane, and which part of a ray lies there.
#pragma once

#include <algorithm>
#include <limits>

#include "meniscus/vec3.h"

namespace meniscus {

/// Part of a ray, in distances from its origin, Å; empty unless begin < end.
struct Interval {
    double begin = 0.0;
    double end = std::numeric_limits<double>::infinity();
};

/// The points on the side of a plane from which its normal points away.
struct HalfSpace {
    Vec3 point;   ///< on the plane
    Vec3 normal;  ///< unit vector

    double height(const Vec3& p) const { return dot(p - point, normal); }  ///< above the plane, Å
    bool contains(const Vec3& p) const { return height(p) <= 0.0; }

    /// direction  unit vector
    Interval part_of_ray(const Vec3& origin, const Vec3& direction) const {
        const double rise = dot(direction, normal);
        const double above = height(origin);
        if (rise < 0.0) return {.begin = std::max(0.0, above / -rise)};
        if (above > 0.0) return {.end = 0.0};
        return rise > 0.0 ? Interval{.end = -above / rise} : Interval{};
    }
};

}  // namespace meniscus
