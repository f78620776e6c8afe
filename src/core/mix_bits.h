// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Hashes that stand in for chance: the same for the same thing, on any machine.
#pragma once

#include <cstdint>

namespace meniscus {

/// Finaliser of splitmix64 (Steele, Lea & Flood 2014): every bit of the result depends on every bit of h.
constexpr std::uint64_t mix_bits(std::uint64_t h) {
    h = (h ^ (h >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    h = (h ^ (h >> 27U)) * 0x94D049BB133111EBULL;
    return h ^ (h >> 31U);
}

/// The increment of splitmix64, to tell successive inputs apart.
inline constexpr std::uint64_t kMixIncrement = 0x9E3779B97F4A7C15ULL;

/// A number in [-1, 1) from a mixed hash.
constexpr double signed_unit(std::uint64_t mixed) { return static_cast<double>(mixed >> 11U) * 0x1p-52 - 1.0; }

}  // namespace meniscus
