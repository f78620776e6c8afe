// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Atoms at one and the same place.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus::reading {

/// Number of points that lie exactly where another one lies, the first of each place not counted.
/// cost   O(n log n)
inline std::size_t count_coincident(std::vector<Vec3> points) {
    std::sort(points.begin(), points.end(),
              [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    const auto last = std::unique(points.begin(), points.end());
    return static_cast<std::size_t>(points.end() - last);
}

}  // namespace meniscus::reading
