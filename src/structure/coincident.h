// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Atoms at one and the same place.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <tuple>
#include <vector>

#include "core/mix_bits.h"
#include "meniscus/vec3.h"

namespace meniscus::reading {

/// Number of points that lie exactly where another one lies, the first of each place not counted.
/// cost   O(n log n)
inline std::size_t count_coincident(std::vector<Vec3> points) {
    // Nearly always there are none, which numbers tell sooner than points: only equal ones can be at one place.
    std::vector<std::uint64_t> numbers;
    numbers.reserve(points.size());
    for (const Vec3& p : points) {
        std::uint64_t number = 0;
        for (const double v : {p.x, p.y, p.z})
            number = mix_bits(number ^ std::bit_cast<std::uint64_t>(v + 0.0)) + kMixIncrement;  // + 0.0: -0 is 0
        numbers.push_back(number);
    }
    std::sort(numbers.begin(), numbers.end());
    if (std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end()) return 0;
    std::sort(points.begin(), points.end(),
              [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    const auto last = std::unique(points.begin(), points.end());
    return static_cast<std::size_t>(points.end() - last);
}

}  // namespace meniscus::reading
