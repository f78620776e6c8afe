// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A small molecule with its surface, for tests.
#pragma once

#include "support/shapes.h"
#include "support/small_structures.h"

namespace meniscus::testing {

/// Two atoms far apart, each with its own sphere as surface; the second sphere is the wall of a cavity.
struct SmallMolecule {
    SmallMolecule() : structure(two_atoms()) {
        for (std::uint32_t i = 0; i < 2; ++i) {
            Mesh sphere = projected_sphere({structure.atoms.centres[i], structure.atoms.radii[i]}, 0.5);
            mesh.atoms.insert(mesh.atoms.end(), sphere.vertices.size(), i);
            mesh.components.insert(mesh.components.end(), sphere.vertices.size(), i);
            mesh.normals.insert(mesh.normals.end(), sphere.normals.begin(), sphere.normals.end());
            append(mesh, i == 0 ? sphere : turned_inside_out(sphere));
        }
        mesh.patches.assign(mesh.vertices.size(), PatchKind::Contact);
        mesh.mean_curvatures.assign(mesh.vertices.size(), 0.6F);
    }

    Structure structure;
    Mesh mesh;
};

}  // namespace meniscus::testing
