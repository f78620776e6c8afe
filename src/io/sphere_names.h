// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Names of atoms in the form that MSMS reads and writes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "meniscus/structure.h"

namespace meniscus {

/// ATOM_RESIDUE_NUMBER_CHAIN without blanks, "CA_GLY_35_A"; "-" stands for what has no name.
std::string sphere_name(const Structure& structure, std::size_t atom);

/// Of all atoms; empty if none has a name, as in .xyzr files.
/// throws   UsageError as check_labels()
std::vector<std::string> sphere_names(const Structure& structure);

}  // namespace meniscus
