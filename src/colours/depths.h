// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How deep in pockets and cavities a surface lies.
#pragma once

#include <vector>

#include "meniscus/exact_surface.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// Of each vertex, how far it lies within the SES of a probe of kDepthProbe, Å; 0 outside.
/// cost     O(n log n)
std::vector<double> depths(const Mesh& mesh, const ExactSurface& exact);

/// The values "depth" of the mesh, or nothing where it has none.
const VertexValues* brought_depths(const Mesh& mesh);

}  // namespace meniscus
