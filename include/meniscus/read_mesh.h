// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Meshes of other programs, and our own, read back.
#pragma once

#include <string>

#include "meniscus/mesh.h"

namespace meniscus {

/// Reads positions and triangles of a mesh; whatever else a file holds is passed over, but must be well-formed.
///
/// The suffix says the format, also before .gz: .ply (text, binary of either byte order), .obj, .stl (text or binary,
/// told by content; corners at the same place become one vertex), .off, .glb (nodes' transformations applied), and
/// .vert or .face for the pair of files that MSMS writes. Polygons become fans of triangles round their first corner.
/// Triangles keep the order of their corners; those of no area and vertices without triangles stay.
///
/// throws   InputError "FILE:LINE:COLUMN: what is wrong; what to do", for binary files "FILE:byte N: ...", for what
///          cannot be read, is not well-formed, or has corners that name no vertex and coordinates that are no finite
///          numbers up to kFarthestCoordinate; UsageError for another suffix; LimitError for more vertices than a mesh
///          can have
/// cost     O(n). Nothing is allocated that the file is too short to hold
Mesh read_mesh(const std::string& path);

/// True if the name ends as those of meshes that read_mesh() reads do.
bool is_mesh_file(const std::string& path);

}  // namespace meniscus
