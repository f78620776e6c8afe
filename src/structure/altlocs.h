// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Choice among alternative locations.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Of each site (chain, segment, residue number, insertion code) keeps one alternative: `wanted` where the site has
/// it, else the one with the highest summed occupancy, the first of the file on ties. Alternatives may be residues of
/// different names. Atoms without an alternative letter stay.
///
/// kept     indices into model.atoms, in file order
/// returns  those that stay, in the same order
std::vector<std::uint32_t> choose_altlocs(const RawModel& model, const std::vector<std::uint32_t>& kept,
                                          const std::string& wanted);

}  // namespace meniscus::reading
