// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Writers: a surface's mesh and a structure's kept atoms, as files that other programs read.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "meniscus/mesh.h"
#include "meniscus/structure.h"

namespace meniscus {

enum class Encoding { Binary, Text };

/// One more value per vertex, such as `residue`; the name must be a word that the format can hold.
struct VertexArray {
    std::string name;
    std::variant<std::span<const std::uint32_t>, std::span<const float>> values;
};

struct WriteOptions {
    Encoding encoding = Encoding::Binary;  ///< of PLY and STL; OBJ and OFF are text
    std::vector<VertexArray> extra{};      ///< written by formats with named vertex values (PLY), after the mesh's own
};

/// Writes a mesh; the suffix of `path` chooses the format: .ply .obj .stl .off.
///
/// Written to a temporary name in the same folder and renamed: a failed run leaves no half file and an older file as it
/// was. Devices and pipes (/dev/stdout) are written to directly. Coordinates are rounded to single precision unless
/// that would move them by 1e-4 Å or make two corners of a triangle coincide; then they are written in full. (Binary
/// STL has single precision only.)
/// throws   UsageError for an unknown suffix or arrays whose sizes do not match; LimitError for more triangles than the
///          format can count; OutputError when the file cannot be written
void write_mesh(const std::string& path, const Mesh& mesh, const WriteOptions& options = {});

/// Writes the kept atoms as "x y z radius" (.xyzr) or "x y z radius 1 ATOM_RESIDUE_NUMBER_CHAIN" (.xyzrn), Å, with
/// enough digits to read the same numbers back.
/// throws   as write_mesh
void write_spheres(const std::string& path, const Structure& structure);

/// Writes the table of kept atoms that a mesh's `atoms` indexes (NAME.atoms.csv), comma-separated as RFC 4180 says.
/// throws   OutputError
void write_atom_table(const std::string& path, const Structure& structure);

}  // namespace meniscus
