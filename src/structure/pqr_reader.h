// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Reader of PQR: atoms with charges and radii.
#pragma once

#include <string>
#include <string_view>

#include "structure/pdb_screen.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// PQR: ATOM and HETATM lines of blank-separated words, "ATOM serial name residue [chain] number x y z charge radius
/// [element]". Number and insertion code may be one word (27A), and so may what has grown together in the columns of
/// PDB2PQR (pqr_words.h). Records of PDB files without atoms are passed over, other lines with a note.
///
/// throws   InputError with line and column, also for a line of no known record that may be meant as an atom, and for
///          an atom behind another one or another record in its line
RawModel parse_pqr(std::string_view text, const std::string& file);

/// The same of a part of the text.
RawModel parse_pqr(std::string_view text, const PdbModelSpan& part, const std::string& file);

/// The models of a PQR file, which MODEL and ENDMDL tell apart, but neither TER nor END. Their parts make up the whole
/// text, and there is always one.
PdbModels find_pqr_models(std::string_view text);

}  // namespace meniscus::reading
