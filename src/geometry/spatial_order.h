// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The order in which a BoxTree wants its items.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Numbers of a mesh's triangles along a space-filling curve, by their first corners; ties as in the mesh.
///
/// cost     O(n log n)
std::vector<std::uint32_t> triangles_in_spatial_order(const Mesh& mesh);

}  // namespace meniscus
