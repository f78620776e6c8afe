// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What belongs to triangles, summed at their corners.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// For every vertex the sum of the numbers of the triangles around, in the order of the triangles.
///
/// of_triangle   one number per triangle
/// Precondition: every corner is below vertex_count.
/// cost     O(n) for n triangles, 2 ns each, on up to two threads
std::vector<float> sums_at_corners(std::size_t vertex_count, std::span<const Triangle> triangles,
                                   std::span<const float> of_triangle);

}  // namespace meniscus
