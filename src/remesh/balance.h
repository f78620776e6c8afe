// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Flat triangles on both sides of the surface that they stand for.
#pragma once

#include "remesh/remesher.h"

namespace meniscus {

/// Moves vertices that lie on a surface off it along their normals, as far as the triangles round them lie below it in
/// the mean: out of what is convex, into what is concave. The triangles then lie on both sides, half as far away, and
/// enclose the volume that the surface does. Vertices stay where the mesh would pass through itself anywhere new, or
/// get an angle below 25 degrees.
///
/// mesh   even triangles with edges near `edge` Å and the surface's normals; nothing but the vertices changes
/// cost   one projection per triangle
void balance_triangles(Mesh& mesh, double edge, const SurfaceProjector& project);

}  // namespace meniscus
