// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Tells polymer, ligands, ions and water apart.
#pragma once

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Sets the kind of every residue.
///
/// Water is known by its name. ATOM records are polymer. A HETATM residue is polymer if the file lists it in a
/// sequence (mmCIF entities, SEQRES up to TER), or if a peptide or phosphodiester bond links it to a polymer residue
/// next to it in the file or in number: MSE, a chromophore, a blocking group, but no sugar on a side chain. Of the
/// rest, groups of one atom are ions, all others ligands.
/// Precondition: every residue has an atom.
void classify_residues(RawModel& model);

}  // namespace meniscus::reading
