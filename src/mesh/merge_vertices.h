// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Vertices at the same place made one.
#pragma once

#include <cstddef>

#include "meniscus/mesh.h"

namespace meniscus {

/// Makes vertices with exactly the same coordinates one, the first of them, and drops those without triangles. The mesh
/// must have finite coordinates and no other vertex array. Triangles keep their order, also those that lose their area.
/// returns  how many vertices are gone
/// cost     O(n log n)
std::size_t merge_vertices(Mesh& mesh);

}  // namespace meniscus
