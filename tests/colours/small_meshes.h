// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Meshes whose colours can be told by looking.
#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "meniscus/mesh.h"
#include "support/shapes.h"
#include "tables/small_complex.h"

namespace meniscus::testing {

/// A mesh of one vertex per atom of small_complex(), with patches in turn.
inline Mesh vertex_per_atom() {
    Mesh mesh;
    mesh.vertices = small_complex().atoms.centres;
    for (std::uint32_t i = 0; i < mesh.vertices.size(); ++i) {
        mesh.atoms.push_back(i);
        mesh.patches.push_back(static_cast<PatchKind>(i % 3));
    }
    return mesh;
}

/// With the first vertex of each component: 0 and 1 are outer, 2 and 3 are cavities in 0.
inline std::pair<Mesh, std::array<std::size_t, 4>> two_outer_pieces_and_two_cavities() {
    Mesh mesh = extracted_sphere({.centre = {}, .radius = 3.0}, 0.5);
    const std::size_t first = mesh.vertices.size();
    append(mesh, extracted_sphere({.centre = {9, 0, 0}, .radius = 1.0}, 0.5));
    const std::size_t second = mesh.vertices.size();
    append(mesh, turned_inside_out(extracted_sphere({.centre = {1, 0, 0}, .radius = 0.8}, 0.5)));
    const std::size_t third = mesh.vertices.size();
    append(mesh, turned_inside_out(extracted_sphere({.centre = {-1, 0, 0}, .radius = 0.7}, 0.5)));
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        mesh.components.push_back(v < first ? 0 : v < second ? 1 : v < third ? 2 : 3);
    return {mesh, {0, first, second, third}};
}

/// Two atoms of 2 Å, 8 Å apart, with a vertex at the far end of one and another between them.
inline std::pair<Mesh, Structure> groove() {
    Structure two;
    two.atoms = {.centres = {{-4.0, 0.0, 0.0}, {4.0, 0.0, 0.0}}, .radii = {2.0, 2.0}};
    two.labels.resize(2);
    Mesh mesh;
    mesh.vertices = {{-6.0, 0.0, 0.0}, {-2.0, 0.0, 0.0}};
    return {mesh, two};
}

}  // namespace meniscus::testing
