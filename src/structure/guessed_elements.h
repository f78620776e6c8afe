// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What is said of elements that the file does not give, and that atom names tell.
#pragma once

#include <string>

#include "structure/choose_atoms.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Sets the guessed elements of atoms that are alone in their residues, where the names tell an ion: "NA" in ION is
/// sodium (element_of_ion).
void correct_lone_ions(RawModel& model);

/// Adds a note for the standard residues, whose names leave no doubt, and a warning for all others, where "CA" may be
/// carbon or calcium, with the elements that were guessed.
///
/// missing   what the file lacks: "columns 77-78 are blank"
void tell_guessed_elements(const RawModel& model, const std::string& missing, Chosen& chosen);

}  // namespace meniscus::reading
