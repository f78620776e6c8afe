// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/simulated_atoms.h"

#include <algorithm>
#include <array>

#include "radii/aliases.h"
#include "reading/text.h"

namespace meniscus::reading {

bool is_standard_name(std::string_view residue) {
    return is_amino_acid(residue) || is_nucleotide(residue) || is_water(residue);
}

bool is_site_of_water(std::string_view atom, std::string_view residue) {
    constexpr auto kSites = std::to_array<std::string_view>({"MW", "M", "EPW", "OM", "LP1", "LP2", "EP1", "EP2", "LP"});
    return is_water(residue) && std::find(kSites.begin(), kSites.end(), atom) != kSites.end();
}

void tell_virtual_sites(std::size_t count, RawModel& model) {
    if (count > 0) model.notes.push_back(counted(count, "virtual site") + " of water left out: no atoms");
}

void tell_hetero_by_name(const std::string& source, RawModel& model) {
    if (std::any_of(model.atoms.begin(), model.atoms.end(), [](const RawAtom& atom) { return atom.hetatm; }))
        model.notes.push_back(
            "residues that are neither amino acids nor nucleotides nor water taken as hetero groups: " + source +
            " not tell them");
}

}  // namespace meniscus::reading
