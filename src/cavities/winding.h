// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// On which side of a closed mesh points are.
#pragma once

#include <span>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// How often a mesh winds round each point: for a closed one 1 inside the molecule, 0 in the solvent.
///
/// A ray upwards from each point is followed through all triangles. Rays through an edge or a vertex are decided the
/// same way by all triangles there, so none is counted twice or lost.
/// cost     parallel over triangles; 4 bytes a vertex and some ns a triangle, however many the points: seen from above
///          they lie in cells, 64 for each
std::vector<int> winding_numbers(const Mesh& mesh, std::span<const Vec3> points);

}  // namespace meniscus
