// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A direction across another, where frames begin.
#pragma once

#include <cmath>

#include "meniscus/vec3.h"

namespace meniscus {

/// A unit vector perpendicular to the unit vector `axis`. Duff et al. 2017, "Building an orthonormal basis, revisited":
/// no root and no case near a pole.
inline Vec3 perpendicular(const Vec3& axis) {
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1.0 / (sign + axis.z);
    return {1.0 + sign * axis.x * axis.x * a, sign * axis.x * axis.y * a, -sign * axis.x};
}

}  // namespace meniscus
