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

#include "core/bits.h"
#include "core/mix_bits.h"
#include "meniscus/vec3.h"

namespace meniscus::reading {

/// Those that may lie where another one lies, and few others: whose places share a bit in a table of hashes.
inline std::vector<Vec3> likely_coincident(const std::vector<Vec3>& points) {
    constexpr std::size_t kBitsPerPoint = 16;
    const std::size_t bits = std::bit_ceil(64 + kBitsPerPoint * points.size());
    const auto bit_of = [bits](const Vec3& p) {
        std::uint64_t hash = 0;
        for (const double v : {p.x, p.y, p.z})
            hash = (hash ^ bit_cast<std::uint64_t>(v + 0.0)) * kMixIncrement;  // + 0.0: -0 is 0
        return static_cast<std::size_t>((hash ^ hash >> 32U) & (bits - 1));
    };
    std::vector<std::uint64_t> taken(bits / 64);
    std::vector<std::uint64_t> shared(bits / 64);
    for (const Vec3& p : points) {
        const std::size_t bit = bit_of(p);
        const std::uint64_t mask = std::uint64_t{1} << bit % 64;
        shared[bit / 64] |= taken[bit / 64] & mask;
        taken[bit / 64] |= mask;
    }
    std::vector<Vec3> likely;
    for (const Vec3& p : points)
        if (const std::size_t bit = bit_of(p); (shared[bit / 64] >> bit % 64 & 1U) != 0) likely.push_back(p);
    return likely;
}

/// Number of points that lie exactly where another one lies, the first of each place not counted.
/// cost   O(n) unless most do
inline std::size_t count_coincident(const std::vector<Vec3>& all) {
    std::vector<Vec3> points = likely_coincident(all);
    std::sort(points.begin(), points.end(),
              [](const Vec3& a, const Vec3& b) { return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z); });
    const auto last = std::unique(points.begin(), points.end());
    return static_cast<std::size_t>(points.end() - last);
}

}  // namespace meniscus::reading
