// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "cavities/winding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

#include "core/parallel.h"
#include "platform/fresh_memory.h"
#include "space/point_cells.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 1 << 16;  // triangles or vertices per task
constexpr double kCellsPerPoint = 64.0;  // so many that most are empty

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
    const PointCells cells(points, kCellsPerPoint);
    std::vector<PointCells::Cell> cell_of_vertex;
    resize_touched(cell_of_vertex, mesh.vertices.size());
    parallel_for(mesh.vertices.size(), kChunk,
                 [&](std::size_t v) { cell_of_vertex[v] = cells.cell_of(mesh.vertices[v]); });
    const auto count = [&](std::size_t begin, std::size_t end) {
        Numbers numbers{std::vector<int>(points.size(), 0)};
        for (const Triangle& t : std::span(mesh.triangles).subspan(begin, end - begin)) {
            const auto a = cell_of_vertex[t[0]];
            const auto b = cell_of_vertex[t[1]];
            const auto c = cell_of_vertex[t[2]];
            const auto low = lower(lower(a, b), c);
            const auto high = higher(higher(a, b), c);
            cells.for_each_within(low, high, [&](std::uint32_t i) {
                const int turns = turns_round(mesh, t, points[i]);
                if (turns != 0 && is_above(mesh, t, points[i])) numbers.of_point[i] += turns;
            });
        }
        return numbers;
    };
    Numbers sum = parallel_sum<Numbers>(mesh.triangles.size(), kChunk, count);
    sum.of_point.resize(points.size());
    return std::move(sum.of_point);
}

}  // namespace meniscus
