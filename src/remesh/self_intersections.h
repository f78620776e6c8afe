// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where a mesh passes through itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Where two triangles, told by the numbers and the places of their corners, meet where they should not: without a
/// shared vertex, or with one and beyond it. Triangles that only touch, that lie in one plane or share an edge do not.
std::optional<Vec3> meeting(const Triangle& s, const std::array<Vec3, 3>& s_at, const Triangle& t,
                            const std::array<Vec3, 3>& t_at);
/// The same of two triangles of a mesh.
std::optional<Vec3> meeting(const Mesh& mesh, const Triangle& s, const Triangle& t);

/// A point for every pair of triangles that meet where they should not.
///
/// cost     O(n log n), parallel over triangles
std::vector<Vec3> places_of_self_intersections(const Mesh& mesh);

/// The triangles of these pairs, rising.
std::vector<std::uint32_t> self_intersecting_triangles(const Mesh& mesh);

}  // namespace meniscus
