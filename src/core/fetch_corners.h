// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The corners of triangles, asked for before they are needed: where they lie no processor foresees.
#pragma once

#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Starts to bring the values of a triangle's corners into the cache.
template <class T>
void fetch_corners(const std::vector<T>& of_vertex, const Triangle& triangle) {
    for (const VertexId v : triangle) __builtin_prefetch(&of_vertex[v]);
}

}  // namespace meniscus
