// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Parts of a mesh, with all that is known of their vertices.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

struct MeshPart {
    Mesh mesh;                       ///< triangles and vertices in the order of the whole; arrays as there
    std::vector<VertexId> vertices;  ///< of the whole, ascending: which these are
};

/// The triangles of which two corners at least belong to atoms of a selection. A selection and what it leaves out share
/// no triangle and have them all. The part is open where it ends; areas of vertices stay those of the whole mesh.
///
/// selected   for each atom that mesh.atoms names
/// throws     std::invalid_argument for a mesh without atoms
/// cost       O(n)
MeshPart part_of_atoms(const Mesh& mesh, const std::vector<bool>& selected);

/// One connected piece, by its number in mesh.components.
/// throws   std::invalid_argument for a mesh without components
/// cost     O(n)
MeshPart part_of_component(const Mesh& mesh, std::uint32_t component);

}  // namespace meniscus
