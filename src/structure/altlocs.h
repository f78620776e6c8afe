// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Choice among alternative locations.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

struct AltlocChoice {
    std::vector<std::uint32_t> atoms;  ///< those that stay, in file order
    std::size_t substitutes = 0;       ///< atoms among them with another letter than the wanted one or their site's
};

/// Of each site (chain, segment, residue number, insertion code) keeps one alternative: `wanted` where the site has
/// it, else the one with the highest summed occupancy, the first of the file on ties. Alternatives may be residues of
/// different names.
///
/// An atom of the chosen residue that lacks the letter stays in its own best alternative: main and side chain may have
/// letters of their own, and neither is lost to the other. An atom within 0.5 Å of one that stays is no such atom, but
/// the same one with another name (H and D). Atoms without an alternative letter stay, unless their residue has the
/// same atom with a letter: then having none is an alternative, too.
///
/// kept     indices into model.atoms, in file order; kinds of residues must be set
AltlocChoice choose_altlocs(const RawModel& model, const std::vector<std::uint32_t>& kept, const std::string& wanted);

}  // namespace meniscus::reading
