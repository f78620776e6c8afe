// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// PLY: text or binary, properties of any type and order.
#pragma once

#include "mesh_io/mesh_file.h"

namespace meniscus::reading {

/// Vertices' x, y, z and faces' vertex_indices; other properties and elements are passed over.
/// throws   InputError
Mesh read_ply(const MeshFile& file);

}  // namespace meniscus::reading
