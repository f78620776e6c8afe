// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which nodes of a block lie inside the surface. A block has two units along each axis, each of as many nodes as a word
// has bits.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "grid/block_grid.h"

namespace meniscus {

inline constexpr int kUnitEdge = kBlockEdge / 2;
inline constexpr int kUnitNodes = kUnitEdge * kUnitEdge * kUnitEdge;
inline constexpr int kUnits = kBlockNodes / kUnitNodes;

/// One bit per node of a unit: number x + 4 y + 16 z.
using UnitBits = std::uint64_t;
static_assert(8 * sizeof(UnitBits) == kUnitNodes);
constexpr int node_in_unit(int x, int y, int z) { return x + kUnitEdge * (y + kUnitEdge * z); }

/// One word per unit: number x + 2 y + 4 z.
using InsideBits = std::array<UnitBits, kUnits>;

constexpr bool inside_bit(const InsideBits& bits, int x, int y, int z) {
    const int unit = x / kUnitEdge + 2 * (y / kUnitEdge) + 4 * (z / kUnitEdge);
    const int node = node_in_unit(x % kUnitEdge, y % kUnitEdge, z % kUnitEdge);
    return (bits[static_cast<std::size_t>(unit)] >> node & 1U) != 0;
}

}  // namespace meniscus
