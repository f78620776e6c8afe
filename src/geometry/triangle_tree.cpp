// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/canonical_atoms.h"

namespace meniscus {
namespace {

// By their first corners.
std::vector<std::uint32_t> triangles_in_spatial_order(const Mesh& mesh) {
    constexpr double kCells = (1 << 21) - 1;  // along the longest edge of the box round the mesh
    Box all;
    for (const Vec3& p : mesh.vertices) all.include(p);
    const Vec3 extent = all.high - all.low;
    const double scale = kCells / std::max({extent.x, extent.y, extent.z, 1e-9});
    const auto cell = [scale](double offset) { return static_cast<std::uint32_t>(scale * offset); };
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const Vec3 from = mesh.vertices[t[0]] - all.low;
        const auto number = static_cast<std::uint32_t>(keys.size());
        keys.emplace_back(morton_key(cell(from.x), cell(from.y), cell(from.z)), number);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const auto& [key, triangle] : keys) order.push_back(triangle);
    return order;
}

std::vector<Box> boxes_of(const Mesh& mesh, const std::vector<std::uint32_t>& order) {
    std::vector<Box> boxes;
    boxes.reserve(order.size());
    for (const std::uint32_t t : order) boxes.push_back(box_of(mesh, mesh.triangles[t]));
    return boxes;
}

// The point of a triangle that is nearest to p (Ericson 2005, Real-Time Collision Detection, 5.1.5).
Vec3 nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = dot(ab, p - a);
    const double d2 = dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = dot(ab, p - b);
    const double d4 = dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + (d1 / (d1 - d3)) * ab;
    const double d5 = dot(ab, p - c);
    const double d6 = dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
    const double scale = 1.0 / (va + vb + vc);
    return a + (vb * scale) * ab + (vc * scale) * ac;
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) : order(triangles_in_spatial_order(mesh)), tree(boxes_of(mesh, order)) {}

double TriangleTree::distance(const Mesh& mesh, const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity();
    tree.search_nearest(
        point, [&least] { return least; },
        [&](std::uint32_t i) {
            const auto& [a, b, c] = mesh.triangles[order[i]];
            const Vec3 nearest = nearest_in_triangle(point, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
            least = std::min(least, squared_norm(point - nearest));
        });
    return std::sqrt(least);
}

}  // namespace meniscus
