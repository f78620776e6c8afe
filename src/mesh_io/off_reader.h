// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// OFF, also with normals or colours at the vertices (NOFF, COFF, STOFF).
#pragma once

#include "mesh_io/mesh_file.h"

namespace meniscus::reading {

/// One line per vertex and face; what stands behind positions and corners is passed over.
/// throws   InputError
Mesh read_off(const MeshFile& file);

}  // namespace meniscus::reading
