// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Vertices near a surface become vertices on it that know what the surface is like there.
#pragma once

#include <span>
#include <vector>

#include "geometry/accessible_surface.h"
#include "meniscus/level_set.h"
#include "meniscus/mesh.h"
#include "project/vertex_distances.h"

namespace meniscus {

/// What vertices are projected onto.
struct ProjectionTarget {
    const AccessibleSurface& accessible;
    const LevelSet* level_set = nullptr;  ///< its zero set; null: the exact SES
    double spacing = 0.0;                 ///< of the grid that the vertices come from, Å: limits curvatures
};

/// Projects the vertices of a mesh, which are within a spacing of the surface and next to their neighbours in the
/// array, and fills in their normals, atoms, patches and curvatures; triangles are not looked at.
///
/// returns     distances to the exact SES
VertexDistances finish_vertices(const ProjectionTarget& target, Mesh& mesh);

/// A vertex and where its projection starts, Å.
struct VertexStart {
    VertexId vertex = 0;
    Vec3 from;
};

/// The same for some vertices of a mesh that is finished; all others stay as they are.
///
/// distances   of all vertices to the exact SES
void finish_again(const ProjectionTarget& target, std::span<const VertexStart> starts, Mesh& mesh,
                  VertexDistances& distances);

}  // namespace meniscus
