// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/corner_sums.h"

#include <algorithm>

#include "core/corner_numbers.h"
#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kTogether = 16;  // triangles whose corners are compared as vectors

void add_to_all(std::span<const Triangle> triangles, std::span<const float> of_triangle, std::span<float> sums) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const VertexId v : triangles[t]) sums[v] += of_triangle[t];
}

// Which of some vertices are below another.
struct Sides {
    bool any_below = false;
    bool any_above = false;  // or that one itself
};
Sides sides_of(std::span<const VertexId> vertices, VertexId border) {
    std::uint32_t below = 0;
    std::uint32_t above = 0;
    for (const VertexId v : vertices) {
        below |= static_cast<std::uint32_t>(v < border);
        above |= static_cast<std::uint32_t>(v >= border);
    }
    return {below != 0, above != 0};
}

// Only to the vertices below a border, or only to the others: most neighbours are all on one side.
void add_to_side(bool is_below, VertexId border, std::span<const Triangle> triangles,
                 std::span<const float> of_triangle, std::span<float> sums) {
    for (std::size_t begin = 0; begin < triangles.size(); begin += kTogether) {
        const std::size_t count = std::min(kTogether, triangles.size() - begin);
        const auto some = triangles.subspan(begin, count);
        const Sides sides = sides_of(all_corners(some), border);
        if (!(is_below ? sides.any_below : sides.any_above)) continue;
        if (!(is_below ? sides.any_above : sides.any_below)) {
            add_to_all(some, of_triangle.subspan(begin, count), sums);
            continue;
        }
        for (std::size_t t = begin; t < begin + count; ++t)
            for (const VertexId v : triangles[t])
                if ((v < border) == is_below) sums[v] += of_triangle[t];
    }
}

}  // namespace

std::vector<float> sums_at_corners(std::size_t vertex_count, std::span<const Triangle> triangles,
                                   std::span<const float> of_triangle) {
    std::vector<float> sums(vertex_count);
    if (is_alone()) {
        add_to_all(triangles, of_triangle, sums);
        return sums;
    }
    const auto half = static_cast<VertexId>(vertex_count / 2);
    parallel_both([&] { add_to_side(true, half, triangles, of_triangle, sums); },
                  [&] { add_to_side(false, half, triangles, of_triangle, sums); });
    return sums;
}

}  // namespace meniscus
