// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A BoxTree over the triangles of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/box_tree.h"
#include "meniscus/mesh.h"

namespace meniscus {

struct TriangleTree {
    /// cost     O(n log n)
    explicit TriangleTree(const Mesh& mesh);

    /// From a point to the nearest one of the mesh that the tree was made of, Å; infinite where that has no triangles.
    double distance(const Mesh& mesh, const Vec3& point) const;

    std::vector<std::uint32_t> order;  ///< the triangle of each item: along a space-filling curve, ties as in the mesh
    BoxTree tree;
};

/// The box round a triangle.
inline Box box_of(const Mesh& mesh, const Triangle& triangle) {
    Box box;
    for (const VertexId v : triangle) box.include(mesh.vertices[v]);
    return box;
}

}  // namespace meniscus
