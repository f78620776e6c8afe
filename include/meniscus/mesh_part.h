// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Parts of a mesh, with all vertex arrays.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Some triangles of a whole mesh, as a mesh.
struct MeshPart {
    Mesh mesh;                       ///< triangles, vertices and vertex arrays in the order of the whole mesh
    std::vector<VertexId> vertices;  ///< number that each vertex of the part has in the whole mesh, ascending
};

/// The triangles with at least two corners at selected atoms: every triangle belongs either to a selection or to its
/// complement. The part is open where it ends; areas of vertices stay those of the whole mesh.
///
/// selected   one entry per atom; mesh.atoms indexes it
/// throws     std::invalid_argument for a mesh without atoms, std::out_of_range for an atom without an entry
/// cost       O(n)
MeshPart part_of_atoms(const Mesh& mesh, const std::vector<bool>& selected);

/// The connected piece that has the given number in mesh.components.
/// throws   std::invalid_argument for a mesh without components
/// cost     O(n)
MeshPart part_of_component(const Mesh& mesh, std::uint32_t component);

}  // namespace meniscus
