// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/winding.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numeric>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 1 << 16;  // triangles or vertices per task

// Whether an edge, seen from above, passes a point at larger y. Of its ends exactly one lies right of the point. Both
// triangles of the edge compute the same bits.
bool passes_behind(const Vec3& p, const Vec3& a, const Vec3& b, bool b_is_right) {
    return ((b.x - a.x) * (p.y - a.y) < (b.y - a.y) * (p.x - a.x)) == b_is_right;
}

// How often the triangle, seen from above, runs counter-clockwise round a point.
int turns_round(const Mesh& mesh, const Triangle& t, const Vec3& p) {
    int turns = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [first, second] = std::minmax(t[i], t[(i + 1) % 3]);
        const Vec3& a = mesh.vertices[first];
        const Vec3& b = mesh.vertices[second];
        const bool a_is_right = a.x > p.x;
        const bool b_is_right = b.x > p.x;
        if (a_is_right == b_is_right || !passes_behind(p, a, b, b_is_right)) continue;
        turns += b_is_right == (second == t[i]) ? 1 : -1;
    }
    return turns;
}

// Whether the plane of a triangle, which is not upright, passes above a point.
bool is_above(const Mesh& mesh, const Triangle& t, const Vec3& p) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 normal = cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
    return (dot(normal, a - p) > 0.0) == (normal.z > 0.0);
}

// How many of the sorted xs are left of each vertex. Most vertices have the rank of the one before.
std::vector<std::uint32_t> ranks_of(std::span<const Vec3> vertices, std::span<const double> xs) {
    std::vector<std::uint32_t> ranks(vertices.size());
    parallel_chunks(vertices.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        std::size_t rank = 0;
        double low = -std::numeric_limits<double>::infinity();  // the rank is that of low < x <= high
        double high = low;
        for (std::size_t v = begin; v < end; ++v) {
            const double x = vertices[v].x;
            if (!(low < x && x <= high)) {
                rank = static_cast<std::size_t>(std::lower_bound(xs.begin(), xs.end(), x) - xs.begin());
                low = rank > 0 ? xs[rank - 1] : -std::numeric_limits<double>::infinity();
                high = rank < xs.size() ? xs[rank] : std::numeric_limits<double>::infinity();
            }
            ranks[v] = static_cast<std::uint32_t>(rank);
        }
    });
    return ranks;
}

struct Numbers {
    std::vector<int> of_point;

    Numbers& operator+=(const Numbers& b) {
        of_point.resize(b.of_point.size());
        for (std::size_t i = 0; i < of_point.size(); ++i) of_point[i] += b.of_point[i];
        return *this;
    }
};

}  // namespace

std::vector<int> winding_numbers(const Mesh& mesh, std::span<const Vec3> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a].x < points[b].x; });
    std::vector<double> xs;
    xs.reserve(order.size());
    for (const std::size_t i : order) xs.push_back(points[i].x);

    const std::vector<std::uint32_t> ranks = ranks_of(mesh.vertices, xs);
    const auto count = [&](std::size_t begin, std::size_t end) {
        Numbers numbers{std::vector<int>(points.size(), 0)};
        for (std::size_t n = begin; n < end; ++n) {
            const Triangle& t = mesh.triangles[n];
            const auto [low, high] = std::minmax({ranks[t[0]], ranks[t[1]], ranks[t[2]]});
            for (std::uint32_t rank = low; rank < high; ++rank) {
                const std::size_t i = order[rank];
                const int turns = turns_round(mesh, t, points[i]);
                if (turns != 0 && is_above(mesh, t, points[i])) numbers.of_point[i] += turns;
            }
        }
        return numbers;
    };
    Numbers sum = parallel_sum<Numbers>(mesh.triangles.size(), kChunk, count);
    sum.of_point.resize(points.size());
    return std::move(sum.of_point);
}

}  // namespace meniscus
