// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the units of a block are, and the nodes of a unit: in spacings, unless another unit is given.
#pragma once

#include <cstddef>

#include "grid/inside_bits.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// Of a cube's point from its first one, in steps between them; edge: points along each axis.
constexpr Vec3 place_in_cube(std::size_t number, std::size_t edge) {
    const auto steps = [](std::size_t count) { return static_cast<double>(count); };
    return {steps(number % edge), steps(number / edge % edge), steps(number / (edge * edge))};
}

/// Of a unit's first node from the block's.
constexpr Vec3 unit_steps(std::size_t unit) { return kUnitEdge * place_in_cube(unit, kBlockEdge / kUnitEdge); }

/// Of a node of a unit from its first one.
constexpr Vec3 node_steps(std::size_t node) { return place_in_cube(node, kUnitEdge); }

/// From the first node to the middle of as many along each axis.
constexpr Vec3 to_middle(int edge) { return (0.5 * (edge - 1)) * Vec3{1.0, 1.0, 1.0}; }

/// Å, but for rounding: from there to the farthest node.
inline double half_diagonal(int edge, double spacing) { return spacing * norm(to_middle(edge)); }

}  // namespace meniscus
