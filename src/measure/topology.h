// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How the triangles of a mesh hang together.
#pragma once

#include <cstddef>
#include <span>

#include "meniscus/mesh.h"

namespace meniscus {

/// See MeshMeasures for `closed` and `manifold`.
struct MeshTopology {
    bool closed = true;
    bool manifold = true;
    std::size_t edges = 0;  ///< pairs of different vertices with at least one triangle
};

/// Numbers of triangles to be summed at their corners.
struct CornerSums {
    std::span<const float> of_triangle;
    std::span<float> of_vertex;  ///< in the order of the triangles
};

/// Examines the triangles round every vertex, and takes sums there on the way unless they are empty. A triangle with a
/// repeated vertex is neither closed nor manifold; a vertex without triangles is not manifold. A mesh of nothing is
/// both.
///
/// Precondition: every corner is below vertex_count.
/// cost     O(n) for a mesh of bounded vertex degree, O(n log n) else; a byte of scratch memory per triangle
MeshTopology examine_topology(std::size_t vertex_count, std::span<const Triangle> triangles,
                              const CornerSums& sums = {});

}  // namespace meniscus
