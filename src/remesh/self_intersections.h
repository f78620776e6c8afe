// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where a mesh passes through itself.
#pragma once

#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// A point for every pair of triangles that meet where they should not: without a shared vertex, or with one and beyond
/// it. Triangles that only touch, or that lie in one plane, are not told.
///
/// cost     O(n log n), parallel over triangles
std::vector<Vec3> places_of_self_intersections(const Mesh& mesh);

}  // namespace meniscus
