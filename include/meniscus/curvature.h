// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Curvatures of a surface at a point, and how they follow from each other. Mean and principal curvatures are positive
// where the surface is convex towards the solvent, as on a sphere.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meniscus {

/// Principal curvatures, Å^-1.
struct PrincipalCurvatures {
    double largest = 0.0;
    double smallest = 0.0;

    double mean() const { return 0.5 * (largest + smallest); }
    double gaussian() const { return largest * smallest; }

    /// Shape index in [-1, 1] (Koenderink & van Doorn 1992): 2/π atan((k1 + k2) / (k1 - k2)), k1 >= k2.
    ///
    /// 1 on a ball, 0.5 on a ridge, 0 on a symmetric saddle, -0.5 in a rut, -1 in a cup. If both curvatures are equal,
    /// the index is 1 or -1 by their sign, and 0 on a plane, for which it is undefined.
    double shape_index() const;

    /// Both curvatures limited to [-limit, limit], Å^-1, and 0 instead of NaN: |mean| <= limit, |gaussian| <= limit².
    PrincipalCurvatures capped(double limit) const {
        const auto cap = [limit](double k) { return std::isnan(k) ? 0.0 : std::clamp(k, -limit, limit); };
        return {cap(largest), cap(smallest)};
    }
};

/// Principal curvatures from the mean (Å^-1) and the Gaussian curvature (Å^-2).
///
/// The two are equal if rounding makes gaussian exceed mean². At a cusp, where the mean curvature is infinite, both
/// principal curvatures equal the mean if gaussian is +inf; else one of them is 0.
inline PrincipalCurvatures principal_curvatures(double mean, double gaussian) {
    if (std::isinf(mean)) {
        const double other = gaussian > 0.0 && std::isinf(gaussian) ? mean : 0.0;
        return {std::max(mean, other), std::min(mean, other)};
    }
    const double half_difference = std::sqrt(std::max(0.0, mean * mean - gaussian));
    return {mean + half_difference, mean - half_difference};
}

}  // namespace meniscus
