// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Ligands as sticks and balls, to be drawn beside a surface.
#pragma once

#include <span>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/picture.h"
#include "meniscus/structure.h"

namespace meniscus {

/// Å. Bonds are half a stick in the colour of each of their atoms.
inline constexpr double kStickRadius = 0.22;

/// Å; smaller for hydrogens, larger for metals.
double ball_radius(const AtomLabel& atom);

/// A colour for every atom of ligands: that of its element, as viewers have it (Jmol's), but carbon in the first of a
/// few colours that is far from all those of the surface, or the farthest.
///
/// surface   colours of the surface's vertices
std::vector<Colour> ligand_colours(const Ligands& ligands, std::span<const Colour> surface);

/// The ligands with an atom at most 6 Å from a vertex of the mesh, which may be a part of a surface.
/// cost   O(vertices), and a comparison for every atom within some 10 Å of a vertex
Ligands ligands_near(const Ligands& ligands, const Mesh& mesh);

/// The ligands near the mesh as triangles, whose `components` are the numbers of residues; nothing for those that
/// belong to the surface, which hides them.
///
/// colours   of the mesh's vertices
Bodies ligand_bodies(const Ligands& ligands, const Mesh& mesh, std::span<const Colour> colours);

}  // namespace meniscus
