// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/corner_sums.h"

#include <algorithm>

#include "core/parallel.h"
#include "mesh/corner_numbers.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kTogether = 16;    // triangles whose corners are compared as vectors
constexpr std::size_t kLookedAt = 1024;  // triangles in a row: they stay in a core's cache

void add_to_all(std::span<const Triangle> triangles, std::span<const float> of_triangle, std::span<float> sums) {
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (const VertexId v : triangles[t]) sums[v] += of_triangle[t];
}

// Vertices from the first to before the end.
struct VertexRange {
    VertexId first = 0;
    VertexId end = 0;

    bool has(VertexId v) const { return v - first < end - first; }  // below it is far above, too
};

// Only to the vertices of a range: of most triangles next to each other it has all or none.
void add_within(const VertexRange& range, std::span<const Triangle> triangles, std::span<const float> of_triangle,
                std::span<float> sums) {
    for (std::size_t begin = 0; begin < triangles.size(); begin += kTogether) {
        const std::size_t count = std::min(kTogether, triangles.size() - begin);
        const auto some = triangles.subspan(begin, count);
        std::size_t inside = 0;
        for (const VertexId v : all_corners(some)) inside += range.has(v) ? 1 : 0;
        if (inside == 0) continue;
        if (inside == 3 * count) {
            add_to_all(some, of_triangle.subspan(begin, count), sums);
            continue;
        }
        for (std::size_t t = begin; t < begin + count; ++t)
            for (const VertexId v : triangles[t])
                if (range.has(v)) sums[v] += of_triangle[t];
    }
}

}  // namespace

std::vector<float> sums_at_corners(std::size_t vertex_count, std::span<const Triangle> triangles,
                                   std::span<const float> of_triangle, const CornerLook& look) {
    std::vector<float> sums;
    resize_touched(sums, vertex_count);
    if (is_alone()) {
        for (std::size_t begin = 0; begin < triangles.size(); begin += kLookedAt) {
            const std::span<const Triangle> some =
                triangles.subspan(begin, std::min(kLookedAt, triangles.size() - begin));
            if (look) look(some);
            add_to_all(some, of_triangle.subspan(begin, some.size()), sums);
        }
        return sums;
    }
    if (look)
        parallel_chunks(triangles.size(), kLookedAt,
                        [&](std::size_t begin, std::size_t end) { look(triangles.subspan(begin, end - begin)); });
    const auto count = static_cast<VertexId>(vertex_count);
    const VertexId half = count / 2;
    parallel_both(
        [&] {
            add_within({0, half}, triangles, of_triangle, sums);
        },
        [&] {
            add_within({half, count}, triangles, of_triangle, sums);
        });
    return sums;
}

}  // namespace meniscus
