// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Corners that leave the surface, so that flat triangles lie on both sides of it.
#pragma once

#include <span>
#include <vector>

#include "remesh/remesher.h"

namespace meniscus {

/// How far each vertex of a mesh on a surface is to move along its normal, Å, for the triangles to lie on both sides of
/// the surface, half as far away, and to enclose the volume that it does: as far as the triangles round it lie below
/// the surface in the mean. Out of what is convex, into what is concave.
///
/// mesh   even triangles with edges near `edge` Å and the surface's normals
/// cost   one projection per triangle
std::vector<double> balancing_offsets(const Mesh& mesh, double edge, const SurfaceProjector& project);

/// The vertices of a mesh where they are once they have moved by a share of such offsets.
std::vector<Vec3> vertices_moved(const Mesh& mesh, std::span<const double> offsets, double share);

/// Moves the vertices of a mesh to where they are wanted. They stay where they are where the mesh would pass through
/// itself anywhere new, or get an angle below 25 degrees.
///
/// mesh   even triangles with edges near `edge` Å; nothing but the vertices changes
void move_vertices(Mesh& mesh, std::vector<Vec3> wanted, double edge);

}  // namespace meniscus
