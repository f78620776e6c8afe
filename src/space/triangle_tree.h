// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A BoxTree over the triangles of a mesh.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/mesh.h"
#include "space/box_tree.h"

namespace meniscus {

/// The point of a mesh that is nearest to another.
struct NearestOnMesh {
    Vec3 point;
    /// Å; negative behind the mesh, as seen from where its triangles are counter-clockwise: inside, if it is closed.
    double signed_distance = 0.0;
    std::uint32_t triangle = 0;  ///< one that it lies on
};

struct TriangleTree {
    /// cost     O(n log n)
    explicit TriangleTree(const Mesh& mesh);

    /// From a point to the nearest one of the mesh that the tree was made of, Å; infinite where that has no triangles.
    double distance(const Mesh& mesh, const Vec3& point) const;
    /// The same, sooner than that if a triangle of the mesh is as near as the next ones.
    double distance(const Mesh& mesh, const Vec3& point, std::uint32_t near) const;

    /// The nearest point itself, for a mesh with triangles. Where it lies on several triangles, each counts for the
    /// side by the angle that it takes up there (Bærentzen & Aanæs 2005); they need not share vertices.
    /// near   a triangle of the mesh: the nearer to the point, the sooner
    NearestOnMesh nearest(const Mesh& mesh, const Vec3& point, std::uint32_t near = 0) const;

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
