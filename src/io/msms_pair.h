// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The pair of text files NAME.vert and NAME.face in which MSMS 2.6.1 writes a triangulated surface.
#pragma once

#include <string>

#include "meniscus/mesh.h"
#include "meniscus/structure.h"
#include "meniscus/write.h"

namespace meniscus {

/// "dir/x.face" of "dir/x.vert".
std::string face_path_beside(const std::string& vert_path);

/// Writes what write_mesh() knows of a mesh: names from `structure`, which may be null, vertices per Å² as density.
/// throws   as write_msms
void write_msms_pair(const std::string& vert_path, const Mesh& mesh, const Structure* structure, double probe);

}  // namespace meniscus
