// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/winding.h"

#include <algorithm>
#include <array>
#include <numeric>

namespace meniscus {
namespace {

// On which side of the line from a to b, seen from above, a point is. Both triangles of an edge compute the same bits,
// with opposite sign; a point on the line counts to the left of the direction from the smaller vertex to the larger.
int side_of(const Mesh& mesh, VertexId a, VertexId b, const Vec3& p) {
    const Vec3& from = mesh.vertices[std::min(a, b)];
    const Vec3& to = mesh.vertices[std::max(a, b)];
    const double area = (to.x - from.x) * (p.y - from.y) - (to.y - from.y) * (p.x - from.x);
    const int side = area >= 0.0 ? 1 : -1;
    return a < b ? side : -side;
}

// Whether the plane of a triangle, which is not upright, passes above a point.
bool is_above(const Mesh& mesh, const Triangle& t, const Vec3& p) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 normal = cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
    return (dot(normal, a - p) > 0.0) == (normal.z > 0.0);
}

// 1 where the ray upwards leaves through the triangle, -1 where it enters.
int crossing(const Mesh& mesh, const Triangle& t, const Vec3& p) {
    const int side = side_of(mesh, t[0], t[1], p);
    if (side_of(mesh, t[1], t[2], p) != side || side_of(mesh, t[2], t[0], p) != side) return 0;
    return is_above(mesh, t, p) ? side : 0;
}

}  // namespace

std::vector<int> winding_numbers(const Mesh& mesh, std::span<const Vec3> points) {
    std::vector<std::size_t> order(points.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return points[a].x < points[b].x; });
    std::vector<double> xs;
    xs.reserve(order.size());
    for (const std::size_t i : order) xs.push_back(points[i].x);
    std::vector<int> numbers(points.size(), 0);
    for (const Triangle& t : mesh.triangles) {
        const auto [low, high] = std::minmax({mesh.vertices[t[0]].x, mesh.vertices[t[1]].x, mesh.vertices[t[2]].x});
        const auto end = std::upper_bound(xs.begin(), xs.end(), high);
        for (auto at = std::lower_bound(xs.begin(), end, low); at != end; ++at) {
            const std::size_t i = order[static_cast<std::size_t>(at - xs.begin())];
            numbers[i] += crossing(mesh, t, points[i]);
        }
    }
    return numbers;
}

}  // namespace meniscus
