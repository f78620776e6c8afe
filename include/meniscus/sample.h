// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points spread evenly over a surface, for descriptors, docking and learning.
#pragma once

#include <cstdint>

#include "meniscus/mesh.h"
#include "meniscus/surface.h"

namespace meniscus {

/// How many points are spread over a surface, and which.
struct SampleOptions {
    double density = 1.0;    ///< points per Å² of the mesh, > 0
    std::uint64_t seed = 0;  ///< seed of the random choice of points
    int threads = 0;         ///< 0: all cores; the points do not depend on it
};

/// Spreads points over a surface so that distances between neighbours are all about the same (blue noise).
///
/// Five times as many candidates are thinned out where they are densest. On proteins, the nearest neighbour of 98 in
/// 100 points is 0.70 to 0.96 times as far away as in a triangular lattice, where the distance is sqrt(1.155 /
/// density). Points on different sides of a thin wall or of a sharp crease do not count as neighbours.
///
/// surface  only the pieces that its mesh keeps get points
/// returns  the points as vertices of a mesh without triangles, with every vertex array, in spatial order. Their number
///          is density times the area of the mesh, rounded. They lie on the zero set of the level set, or on the exact
///          SES if there is none, like the vertices of the mesh, with curvatures capped alike and equal areas
/// throws   UsageError for options out of range; LimitError for more points than fit into memory
/// cost     15 to 20 µs of processor time per point
/// source   weighted sample elimination, Yuksel 2015, Computer Graphics Forum 34, 25-32
Mesh sample_surface(const Surface& surface, const SampleOptions& options = {});

}  // namespace meniscus
