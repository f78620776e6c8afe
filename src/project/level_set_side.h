// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// On which side of a level set's surface any point of space lies.
#pragma once

#include <cmath>

#include "core/odd_direction.h"
#include "meniscus/level_set.h"

namespace meniscus {

/// Outside the band: whether what a ray meets first is the surface seen from within.
inline bool is_inside(const LevelSet& level_set, const Vec3& point) {
    const double value = level_set.value(point);
    if (!std::isnan(value)) return value < 0.0;
    const double distance = level_set.intersect(point, kOddDirection);
    if (!std::isfinite(distance)) return false;
    const Vec3 crossing = point + (distance / norm(kOddDirection)) * kOddDirection;
    return dot(level_set.sample(crossing).gradient, kOddDirection) > 0.0;
}

}  // namespace meniscus
