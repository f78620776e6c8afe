// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Reader of PDBQT, the format of AutoDock and Vina: PDB up to column 66, then a partial charge and an atom type.
#pragma once

#include <string>
#include <string_view>

#include "structure/pdb_screen.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Whether a text has an atom with a charge in columns 67-76 and an atom type from column 78 on, as AutoDock has them;
/// a PDB file has a segment and, from column 77 on, an element there.
bool has_pdbqt_atoms(std::string_view text);

/// One model: what find_pdb_models() has found in the text. Elements come from the atom types, where these tell; atom
/// types that stand for no atom (the G0 of broken rings) are left out with a note.
/// throws   InputError with line and column
RawModel parse_pdbqt(std::string_view text, const PdbModelSpan& model, const std::string& file);

}  // namespace meniscus::reading
