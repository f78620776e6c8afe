// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Sides of the nodes of a block, set by hand, for tests.
#pragma once

#include "grid/inside_bits.h"

namespace meniscus::testing {

inline void set_inside(InsideBits& bits, int x, int y, int z) {
    const int unit = x / kUnitEdge + 2 * (y / kUnitEdge) + 4 * (z / kUnitEdge);
    bits[static_cast<std::size_t>(unit)] |= UnitBits{1} << node_in_unit(x % kUnitEdge, y % kUnitEdge, z % kUnitEdge);
}

}  // namespace meniscus::testing
