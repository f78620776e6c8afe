// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Writers: a surface's mesh and a structure's kept atoms, as files that other programs read.
#pragma once

#include <string>

#include "meniscus/mesh.h"
#include "meniscus/structure.h"

namespace meniscus {

enum class Encoding { Binary, Text };

/// Writes a mesh; the suffix of `path` chooses the format: .ply .obj .stl .off.
///
/// Written to a temporary name in the same folder and renamed: a failed run leaves no half file.
/// encoding applies to PLY and STL; OBJ and OFF are text.
/// throws   UsageError for an unknown suffix, OutputError when the file cannot be written
void write_mesh(const std::string& path, const Mesh& mesh, Encoding encoding = Encoding::Binary);

/// Writes the kept atoms as "x y z radius" (.xyzr) or with names (.xyzrn).
/// throws   as write_mesh
void write_spheres(const std::string& path, const Structure& structure);

/// Writes the table of kept atoms that a mesh's `atoms` indexes (NAME.atoms.csv).
/// throws   OutputError
void write_atom_table(const std::string& path, const Structure& structure);

}  // namespace meniscus
