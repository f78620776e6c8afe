// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points spread evenly over the triangles of a mesh.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Points of a mesh's triangles.
struct PointsOnMesh {
    std::vector<Vec3> points;
    std::vector<std::uint32_t> triangles;  ///< on which each lies
};

/// Candidates per point: more make the points more even, and cost more.
inline constexpr std::size_t kCandidatesPerPoint = 5;

/// Points that are independent of each other, except that equal areas have nearly equal numbers of them; in the order
/// of the triangles. Precondition: a mesh with an area, if there are to be points.
PointsOnMesh scatter_points(const Mesh& mesh, std::size_t count, std::uint64_t seed);

/// Blue noise: scatters kCandidatesPerPoint times as many and takes away the one with the closest neighbours until
/// `count` are left. Neighbours are points on triangles that face to the same side.
///
/// cost     15 µs of processor time per point; taking away is sequential
PointsOnMesh spread_points(const Mesh& mesh, std::size_t count, std::uint64_t seed);

}  // namespace meniscus
