// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Two numbers or vectors side by side, in registers that every processor has: half the instructions where two items
// take the same arithmetic. The numbers of the two never meet, so each has the bits that it has alone.
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include "core/arc_tangent_factors.h"
#include "meniscus/vec3.h"

namespace meniscus {

using Pair = double __attribute__((vector_size(16)));

#include "simd/vectors3.inc"

using Pair3 = Vectors3<Pair>;

inline Pair3 both(const Vec3& a, const Vec3& b) { return {Pair{a.x, b.x}, Pair{a.y, b.y}, Pair{a.z, b.z}}; }
inline Pair root(const Pair& v) { return Pair{std::sqrt(v[0]), std::sqrt(v[1])}; }
inline Pair norm(const Pair3& a) { return root(dot(a, a)); }

#include "simd/arc_tangent.inc"

}  // namespace meniscus
