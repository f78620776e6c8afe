// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/corner_sums.h"

namespace meniscus {

std::vector<float> sums_at_corners(std::size_t vertex_count, std::span<const Triangle> triangles,
                                   std::span<const float> of_triangle) {
    std::vector<float> sums(vertex_count);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const VertexId v : triangles[t]) sums[v] += of_triangle[t];
    return sums;
}

}  // namespace meniscus
