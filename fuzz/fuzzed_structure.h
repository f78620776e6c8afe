// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Structures from fuzzed files: what a reader that succeeds has promised.
#pragma once

#include <string>
#include <string_view>

#include "fuzzed_file.h"
#include "meniscus/structure.h"

namespace meniscus::fuzz {

/// Every coordinate finite, every radius finite and positive, labels and residues as many as documented.
void require_sound(const Structure& structure);

/// Reads with the defaults, and what can be read also with assemblies, hydrogens and hetero groups.
void read_in_every_way(const FuzzedFile& file, std::string_view bytes);

/// A PDB file of two chains with alternatives, insertion codes, an ion and a water, for targets that need a structure.
std::string_view small_file();

}  // namespace meniscus::fuzz
