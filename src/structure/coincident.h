// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Atoms at one and the same place.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <tuple>
#include <vector>

#include "core/mix_bits.h"
#include "meniscus/vec3.h"

namespace meniscus::reading {

/// Number of points that lie exactly where another one lies, the first of each place not counted.
/// cost   O(n log n)
inline std::size_t count_coincident(std::span<const Vec3> points) {
    // Nearly always there are none, which numbers tell sooner than points: only equal ones can be at one place.
    std::vector<std::uint64_t> numbers;
    numbers.reserve(points.size());
    for (const Vec3& p : points) numbers.push_back(mix_in(mix_in(mix_in(0, p.x), p.y), p.z));
    std::sort(numbers.begin(), numbers.end());
    if (std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end()) return 0;
    std::vector<Vec3> sorted(points.begin(), points.end());
    std::sort(sorted.begin(), sorted.end(),
              [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    const auto last = std::unique(sorted.begin(), sorted.end());
    return static_cast<std::size_t>(sorted.end() - last);
}

}  // namespace meniscus::reading
