// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: positions and polygons of its lines v and f.
#pragma once

#include "mesh_io/mesh_file.h"

namespace meniscus::reading {

/// Corners may also name texture coordinates and normals, and count from the end (-1). A corner names a vertex before
/// it.
///
/// throws   InputError
Mesh read_obj(const MeshFile& file);

}  // namespace meniscus::reading
