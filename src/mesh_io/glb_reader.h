// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// GLB: binary glTF 2.0, triangles of the default scene.
#pragma once

#include "mesh_io/mesh_file.h"

namespace meniscus::reading {

/// Nodes' transformations are applied; morph targets, skins and instances are not. Compressed meshes are refused.
/// throws   InputError
Mesh read_glb(const MeshFile& file);

}  // namespace meniscus::reading
