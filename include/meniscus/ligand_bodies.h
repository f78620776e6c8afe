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

/// Ligands as triangles, whose `components` are the numbers of residues; nothing for those that belong to the surface,
/// which hides them.
Bodies ligand_bodies(const Ligands& ligands, std::span<const Colour> surface);

}  // namespace meniscus
