// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From kept atoms to the Structure that is handed out, copied to an assembly if one is asked for.
#pragma once

#include <string>

#include "meniscus/structure.h"
#include "structure/assign_radii.h"
#include "structure/choose_atoms.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Fills atoms, labels, residues and ligands without bonds of `structure`: as deposited, or, if `assembly` is not
/// empty, every chain copied as the assembly says. The copies of chain A are A, A-2, A-3 ...; atoms are in the order of
/// the copies.
///
/// throws   InputError if the file has no such assembly or does not say how to build it; LimitError if there would be
///          more atoms than an index can count
void build_structure(const RawModel& model, const Chosen& chosen, const AssignedRadii& radii,
                     const std::string& assembly, Structure& structure);

}  // namespace meniscus::reading
