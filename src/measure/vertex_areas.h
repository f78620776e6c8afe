// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The area of a mesh shared out among its vertices.
#pragma once

#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// A third of the areas of the triangles around each vertex, Å²; they sum to the area of the mesh.
///
/// cost     O(n), on one thread
std::vector<float> vertex_areas(const Mesh& mesh);

}  // namespace meniscus
