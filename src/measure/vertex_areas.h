// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The area of a mesh shared out among its vertices.
#pragma once

#include <span>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// The areas around each vertex, Å²; they sum to the area of the mesh.
///
/// thirds   of the area of every triangle, Å²
/// cost     O(n), on one thread
std::vector<float> vertex_areas(const Mesh& mesh, std::span<const float> thirds);

}  // namespace meniscus
