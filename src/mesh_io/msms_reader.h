// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The pair of files of MSMS, .vert and .face, with the three lines of their headers or without.
#pragma once

#include "mesh_io/mesh_file.h"

namespace meniscus::reading {

/// Corners count from 1.
/// throws   InputError
Mesh read_msms(const MeshFile& vertices, const MeshFile& faces);

}  // namespace meniscus::reading
