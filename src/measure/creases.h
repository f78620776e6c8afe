// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What lies over the triangles of a mesh that a crease of the surface crosses.
#pragma once

#include <cstdint>
#include <span>

#include "measure/triangle_lanes.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// No crease is looked for over a side along which the normal turns by less than this (14 degrees).
inline constexpr double kLeastTurn = 0.25;
/// Nor where it turns by less than this per Å, as on a sphere of 1.1 Å.
inline constexpr double kLeastTurnPerLength = 0.9;

/// A crease is where the surface turns so many times faster than its curvatures at both ends of a side tell,
inline constexpr double kFasterTurn = 1.35;
/// if the tangent planes there meet this near to the side's middle, in its lengths.
inline constexpr double kNearbyCrease = 0.7;

/// Whether a mesh tells what follow_creases needs to know.
bool knows_creases(const Mesh& mesh);

/// Measures the parts of those triangles anew that a crease crosses: they meet there, where the tangent planes of both
/// ends of a side do, and are not extrapolated.
///
/// mesh       with normals and curvatures (knows_creases)
/// triangles  of the lanes
/// looked_at  a bit for each of these that may be creased
void follow_creases(const Mesh& mesh, std::span<const Triangle> triangles, std::uint64_t looked_at,
                    TriangleLanes& lanes);

}  // namespace meniscus
