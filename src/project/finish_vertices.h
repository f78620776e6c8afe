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

/// Puts the vertices of a mesh, which are within a spacing of the surface and next to their neighbours in the array,
/// onto it and fills in their normals, atoms, patches and curvatures; triangles are not looked at.
///
/// level_set   whose zero set they are put onto; null: onto the exact SES
/// spacing     of the grid that they come from, Å: limits curvatures
/// returns     distances to the exact SES
VertexDistances finish_vertices(const AccessibleSurface& accessible, const LevelSet* level_set, double spacing,
                                Mesh& mesh);

/// The same for some vertices of a mesh that is finished, which start from other places; all others stay as they are.
///
/// places      which vertices
/// from        where each of them starts, Å
/// distances   of all vertices to the exact SES
void finish_again(const AccessibleSurface& accessible, const LevelSet* level_set, double spacing,
                  std::span<const VertexId> places, std::vector<Vec3> from, Mesh& mesh, VertexDistances& distances);

}  // namespace meniscus
