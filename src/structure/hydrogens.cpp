// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/hydrogens.h"

#include <algorithm>

#include "radii/aliases.h"

namespace meniscus::reading {

HydrogenCount count_hydrogens(const RawModel& model, const std::vector<std::uint32_t>& kept) {
    const auto in_polymer = [&](std::uint32_t i) {
        return model.residue_of(model.atoms[i]).kind == ResidueKind::Polymer;
    };
    const bool has_polymer = std::any_of(kept.begin(), kept.end(), in_polymer);
    HydrogenCount count;
    const RawResidue* residue = nullptr;  // of the atom before
    bool is_protein = false;
    for (const std::uint32_t i : kept) {
        const RawAtom& atom = model.atoms[i];
        if (residue != &model.residue_of(atom)) {
            residue = &model.residue_of(atom);
            is_protein = has_polymer && !is_nucleotide(residue->name);
        }
        const bool counts = in_polymer(i) || !has_polymer;
        if (is_hydrogen(atom)) {
            ++count.all;
            count.in_polymer += static_cast<std::size_t>(counts);
        } else if (counts) {
            ++(is_protein ? count.protein_heavy : count.other_heavy);
        }
    }
    return count;
}

}  // namespace meniscus::reading
