// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the tangent planes of two points of a surface meet.
#pragma once

#include "meniscus/vec3.h"

namespace meniscus {

/// The point nearest to `from` on both planes: through a and b, with unit normals there. Not finite for parallel ones.
inline Vec3 meeting_of_planes(const Vec3& a, const Vec3& normal_a, const Vec3& b, const Vec3& normal_b,
                              const Vec3& from) {
    const double cosine = dot(normal_a, normal_b);
    const double off_a = dot(normal_a, a - from);
    const double off_b = dot(normal_b, b - from);
    const double scale = 1.0 / (1.0 - cosine * cosine);
    return from + (scale * (off_a - cosine * off_b)) * normal_a + (scale * (off_b - cosine * off_a)) * normal_b;
}

}  // namespace meniscus
