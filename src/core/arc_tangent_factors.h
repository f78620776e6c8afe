// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The arc tangent's series, arctan t = t + t³ (f₀ + f₁ t² + ...), where |t| is at most tan(π/8).
#pragma once

namespace meniscus {

/// The factors f, those of Chebyshev's polynomial on that range: it is off by 6e-18 of the result.
inline constexpr double kArcTangentFactors[] = {-0.33333333333333331,  0.19999999999995521,   -0.14285714284666542,
                                                0.11111111015256361,   -0.090909045781238734, 0.076921831908254329,
                                                -0.066645114473727313, 0.058581489127221394,  -0.050854497375212498,
                                                0.039231658283482157,  -0.019176887104237525};

inline constexpr double kTangentOfEighth = 0.41421356237309503;  ///< tan(π/8)

}  // namespace meniscus
