// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Creases of the surface as edges of the mesh.
#pragma once

#include <array>
#include <optional>

#include "remesh/working_mesh.h"

namespace meniscus {

/// Puts a vertex held as a ridge into every edge that crosses a crease, where the tangent planes of both ends meet:
/// vertices of neighbouring triangles then share an edge, which runs along the crease. Creases around some places are
/// left out.
///
/// source   Kobbelt et al. 2001, Feature sensitive surface extraction from volume data
void insert_ridges(WorkingMesh& mesh, const SurfaceProjector& project, const Surroundings& left_out);

/// The point of a crease near the middle of an edge along it; the corners of the edge's triangles lie on its two sides.
std::optional<Vec3> point_on_ridge(const Vec3& near, const std::array<Vec3, 2>& corners,
                                   const SurfaceProjector& project);

}  // namespace meniscus
