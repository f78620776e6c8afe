// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Handles and tunnels that are too narrow for the triangles of a mesh.
#pragma once

#include <cstddef>

#include "meniscus/mesh.h"
#include "remesh/remesher.h"

namespace meniscus {

struct CutMesh {
    Mesh mesh;                ///< positions and triangles
    std::size_t handles = 0;  ///< cut, each of which raises the Euler characteristic by 2
};

/// Cuts handles and closes tunnels that are narrower than an edge: where a loop of edges shorter than pi times that
/// does not separate the surface, the surface is cut along it, both ends are drawn back a little and capped. Loops that
/// separate stay, so that no piece becomes two; so do those whose caps would pass through the mesh.
///
/// mesh      closed oriented 2-manifold, best with triangles of about that size
/// returns   a closed oriented 2-manifold with as many pieces; vertices off the loops are the same bits
/// throws    as HalfEdges
/// cost      O(n) for triangles of about that size
CutMesh cut_narrow_handles(const Mesh& mesh, double edge, const SurfaceProjector& project);

}  // namespace meniscus
