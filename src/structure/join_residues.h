// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Residues that a file has in several pieces.
#pragma once

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Makes one residue of pieces with the same chain, number, insertion code and name: atoms with and without a segment
/// identifier, hydrogens or alternatives at the end of the file. Pieces stay apart if an atom name occurs in both with
/// the same alternative letter, as in the chains of an MD program that have only segments to tell them apart. All
/// residues of one site get the same segment, whatever their names.
///
/// cost   O(n log n) for the atoms of sites that occur more than once, O(residues) for the others
void join_residues(RawModel& model);

}  // namespace meniscus::reading
