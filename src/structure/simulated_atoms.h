// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What files of simulations do not tell: which residues are hetero groups, which points are no atoms.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Whether a residue is an amino acid, a nucleotide or water by its name, in upper case.
bool is_standard_name(std::string_view residue);

/// Whether an atom of this name is a place of charge of a four- or five-point water.
bool is_site_of_water(std::string_view atom, std::string_view residue);

/// Adds a note if points were left out because they are no atoms.
void tell_virtual_sites(std::size_t count, RawModel& model);

/// Adds a note if there are hetero groups, which only their names tell.
///
/// source   who does not tell them, with the verb: "GROMACS files do"
void tell_hetero_by_name(const std::string& source, RawModel& model);

}  // namespace meniscus::reading
