// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which atoms of ligands are bonded, and which ligands go with a chain.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "meniscus/structure.h"

namespace meniscus::reading {

/// Pairs of atoms closer than the sum of their covalent radii and 0.4 Å, and farther than 0.4 Å, where one of them
/// would be an alternative of the other. Two metals are not bonded (those of a cluster are by what lies between them),
/// nor are two hydrogens.
/// returns  as Ligands::bonds
/// cost     O(n log n), and a comparison for every pair of atoms whose x differs by less than the longest bond
std::vector<std::array<std::uint32_t, 2>> find_bonds(const Ligands& ligands);

/// The residues that are wanted alone, with their bonds.
Ligands part_of_ligands(const Ligands& ligands, const std::vector<bool>& wanted);

/// Those of a chain alone, with their bonds.
Ligands ligands_of_chain(const Ligands& ligands, const std::string& chain);

}  // namespace meniscus::reading
