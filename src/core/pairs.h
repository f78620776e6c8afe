// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Two numbers or vectors side by side, in registers that every processor has: half the instructions where two items
// take the same arithmetic. The numbers of the two never meet, so each has the bits that it has alone.
#pragma once

#include <cmath>
#include <cstddef>
#include <iterator>
#include <numbers>

#include "meniscus/vec3.h"

namespace meniscus {

using Pair = double __attribute__((vector_size(16)));

/// By component.
struct Pair3 {
    Pair x;
    Pair y;
    Pair z;

    Vec3 operator[](std::size_t i) const { return {x[i], y[i], z[i]}; }
};

inline Pair3 both(const Vec3& a, const Vec3& b) { return {Pair{a.x, b.x}, Pair{a.y, b.y}, Pair{a.z, b.z}}; }
inline Pair3 operator+(const Pair3& a, const Pair3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Pair3 operator-(const Pair3& a, const Pair3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Pair3 operator*(const Pair& s, const Pair3& a) { return {s * a.x, s * a.y, s * a.z}; }
inline Pair dot(const Pair3& a, const Pair3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Pair3 cross(const Pair3& a, const Pair3& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline Pair root(const Pair& v) { return Pair{std::sqrt(v[0]), std::sqrt(v[1])}; }
inline Pair norm(const Pair3& a) { return root(dot(a, a)); }

/// std::atan2, to three units in the last place and with no sign of zeros: 0 where both are 0.
///
/// Of the quotient up to tan(π/8), and π/4 more of (q - 1) / (q + 1) beyond it; the polynomial, Chebyshev's on that
/// range, is off by 6e-18 of the result.
inline Pair arc_tangent(const Pair& y, const Pair& x) {
    constexpr double kFactors[] = {-0.33333333333333331,  0.19999999999995521,   -0.14285714284666542,
                                   0.11111111015256361,   -0.090909045781238734, 0.076921831908254329,
                                   -0.066645114473727313, 0.058581489127221394,  -0.050854497375212498,
                                   0.039231658283482157,  -0.019176887104237525};
    constexpr double kPi = std::numbers::pi;
    const Pair across = y < 0.0 ? -y : y;
    const Pair along = x < 0.0 ? -x : x;
    const Pair low = across < along ? across : along;
    const Pair high = across < along ? along : across;
    const auto turned = low > 0.41421356237309503 * high;
    const Pair divisor = turned ? high + low : high;
    const Pair t = (turned ? low - high : low) / (divisor > 0.0 ? divisor : Pair{} + 1.0);
    const Pair t2 = t * t;
    Pair series{};
    for (std::size_t i = std::size(kFactors); i-- > 0;) series = t2 * (series + kFactors[i]);
    Pair angle = (turned ? Pair{} + 0.25 * kPi : Pair{}) + (t + t * series);
    angle = across > along ? 0.5 * kPi - angle : angle;
    angle = x < 0.0 ? kPi - angle : angle;
    return y < 0.0 ? -angle : angle;
}

}  // namespace meniscus
