// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// STL, text or binary.
#pragma once

#include "mesh_io/mesh_file.h"

namespace meniscus::reading {

/// Corners at the same place become one vertex.
/// throws   InputError
Mesh read_stl(const MeshFile& file);

}  // namespace meniscus::reading
