// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Corners of even triangles leave the surface, for the triangles to be nearer to it.
#pragma once

#include "geometry/accessible_surface.h"
#include "meniscus/mesh.h"
#include "meniscus/remesh.h"
#include "remesh/remesher.h"

namespace meniscus {

/// Moves the corners of triangles on the surface to where they are wanted and returns whether any was to move. Nothing
/// but the vertices changes.
///
/// mesh  even triangles with the surface's normals
/// cost  one projection per triangle; Corners::Near also looks at up to 65,536 points seven times
bool move_corners(Mesh& mesh, const RemeshOptions& even, const AccessibleSurface& surface,
                  const SurfaceProjector& project);

}  // namespace meniscus
