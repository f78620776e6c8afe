// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What belongs to triangles, summed at their corners.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Looks at some triangles in a row; called from several threads at once.
using CornerLook = std::function<void(std::span<const Triangle> some)>;

/// For every vertex the sum of the numbers of the triangles around, in the order of the triangles.
///
/// of_triangle   one number per triangle
/// look          called for every triangle once, before it is followed to its corners; what it throws ends the sums
/// Precondition: every corner is below vertex_count, or look throws.
/// cost     O(n) for n triangles, 2 ns each, on up to two threads
std::vector<float> sums_at_corners(std::size_t vertex_count, std::span<const Triangle> triangles,
                                   std::span<const float> of_triangle, const CornerLook& look = {});

}  // namespace meniscus
