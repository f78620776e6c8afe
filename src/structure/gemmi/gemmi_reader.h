// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The parser of PDB, and the selection syntax. gemmi_reader.cpp is the only file that includes gemmi's model of a
// structure, which compiles slowly.
#pragma once

#include <string>
#include <vector>

#include "structure/pdb_screen.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Parses a screened PDB model.
/// throws   InputError
RawModel parse_pdb(CleanPdb clean, const std::string& file);

/// For each atom, whether it is in the selection (gemmi's syntax: /model/chain/10-50/CA[C]:A;q>0.5,
/// or what restated_selection() puts into it), or in any of several with " + " between them.
///
/// model_position  what a model number in the expression is compared with
/// option          named in messages
/// throws          UsageError if the expression is not valid
std::vector<bool> selected_atoms(const RawModel& model, const std::string& expression, int model_position,
                                 const std::string& option);

/// How a selection is understood that is not in gemmi's syntax: "//A" for "chain A", "(HEM)" for a bare name that no
/// chain and no atom has; empty where it is taken as it stands. Parameters and what it throws as for selected_atoms().
std::string restated_selection(const RawModel& model, const std::string& expression, const std::string& option);

}  // namespace meniscus::reading
