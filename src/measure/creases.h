// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What lies over the triangles of a mesh that a crease of the surface crosses.
#pragma once

#include <optional>

#include "measure/triangle_sum.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// No crease is looked for over a side along which the normal turns by less than this (14 degrees).
inline constexpr double kLeastTurn = 0.25;
/// Nor where it turns by less than this per Å, as on a sphere of 1.1 Å.
inline constexpr double kLeastTurnPerLength = 0.9;

/// Whether a mesh tells what parts_over_crease needs to know.
bool knows_creases(const Mesh& mesh);

/// The four parts of a triangle with a crease over one or more of its sides, where the tangent planes of both ends
/// meet; nothing if there is none. A crease is where the surface turns faster than its curvatures at both ends tell.
///
/// mesh   with normals and curvatures (knows_creases)
std::optional<TriangleSum> parts_over_crease(const Mesh& mesh, const Triangle& triangle, const Vec3& origin);

}  // namespace meniscus
