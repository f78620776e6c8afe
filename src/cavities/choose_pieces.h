// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which closed pieces of a zero set are too small to be meshed.
#pragma once

#include <cmath>
#include <cstddef>
#include <numbers>

#include "meniscus/cavities.h"
#include "meniscus/mesh.h"
#include "remesh/remesher.h"

namespace meniscus {

/// The solid angle of a triangle seen from a point, steradian, positive from behind (Van Oosterom & Strackee 1983).
double solid_angle(const Vec3& from, const Mesh& mesh, const Triangle& triangle);

/// Whether a closed surface whose triangles fill such a solid angle lies round the point.
inline bool is_all_round(double angle) { return std::abs(angle) > 2.0 * std::numbers::pi; }  // 4 pi within, 0 without

/// Drops the walls of cavities that enclose less than a volume, and the islands within these.
///
/// zero_set       as extract_zero_set gives it; triangles and positions that stay are the same bits
/// least_volume   Å³, held against what a wall's triangles enclose once its vertices lie on the surface
/// returns        how many pieces went
/// walls          if there is one: becomes the mesh of what is dropped, with its components
DroppedPieces drop_small_cavities(Mesh& zero_set, double least_volume, const SurfaceProjector& project,
                                  Mesh* walls = nullptr);

/// Drops the pieces that fit into a ball of this diameter, Å, round the mean of their vertices, all but the largest
/// outer one. Returns how many they were.
std::size_t drop_tiny_pieces(Mesh& zero_set, double diameter);

}  // namespace meniscus
