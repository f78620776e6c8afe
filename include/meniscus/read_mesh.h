// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Reads meshes written by this library or by other programs.
#pragma once

#include <string>

#include "meniscus/mesh.h"

namespace meniscus {

/// Reads positions (taken as Å) and triangles of a mesh; anything else in the file is skipped, but must be well-formed.
///
/// The suffix, also before .gz, gives the format: .ply (text, binary of either byte order), .obj, .stl (text or binary,
/// recognised by content; corners at the same place become one vertex), .off, .glb (with the transformations of nodes),
/// and .vert or .face for the pair of files that MSMS writes. Polygons become fans of triangles around their first
/// corner. Triangles keep the order of their corners. Triangles without area and vertices without triangles stay.
///
/// throws   InputError "FILE:LINE:COLUMN: what is wrong; what to do", or "FILE:byte N: ..." for binary files, for a
///          file that cannot be read or is not well-formed, a corner without a vertex, and a coordinate that is not
///          finite or beyond kFarthestCoordinate; UsageError for another suffix; LimitError for more vertices than a
///          mesh can have
/// cost     O(n). Memory is allocated only after sizes are checked against the length of the file
Mesh read_mesh(const std::string& path);

/// True if the path has a suffix that read_mesh() reads.
bool is_mesh_file(const std::string& path);

}  // namespace meniscus
