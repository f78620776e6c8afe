// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Caps of random directions, and caps as contours are built from them, for tests.
#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "geometry/contour.h"
#include "geometry/neighbour_caps.h"

namespace meniscus::testing {

inline Vec3 random_direction(std::mt19937_64& random) {
    std::normal_distribution<double> normal;
    return normalised({normal(random), normal(random), normal(random)});
}

/// Numbered by position; t between `low` and `high`.
inline std::vector<Cap> random_caps(std::uint64_t seed, std::uint32_t count, double low, double high) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> t(low, high);
    std::vector<Cap> caps;
    for (std::uint32_t i = 0; i < count; ++i) caps.push_back({random_direction(random), t(random), i});
    return caps;
}

inline CapColumns columns_of(std::span<const Cap> caps) {
    CapList list;
    for (const Cap& cap : caps) list.add(cap);
    return std::move(list.planes);
}

/// Of the caps that a contour was built from, those that it numbers.
inline std::vector<Cap> kept_of(const ContourBuilder& builder, std::span<const Cap> caps) {
    std::vector<Cap> kept;
    for (const std::uint32_t k : builder.kept()) kept.push_back(caps[k]);
    return kept;
}

}  // namespace meniscus::testing
