// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/triangle_tree.h"

#include <algorithm>
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

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) : order(triangles_in_spatial_order(mesh)), tree(boxes_of(mesh, order)) {}

}  // namespace meniscus
