// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/labels.h"

#include <algorithm>

#include "meniscus/errors.h"

namespace meniscus {

void check_labels(const Structure& structure) {
    const std::size_t n = structure.atoms.size();
    if (structure.atoms.radii.size() != n || structure.labels.size() != n)
        throw UsageError("a structure needs one radius and one label per atom");
    const bool residues_exist = std::all_of(structure.labels.begin(), structure.labels.end(),
                                            [&](const AtomLabel& l) { return l.residue < structure.residues.size(); });
    if (!structure.residues.empty() && !residues_exist)
        throw UsageError("an atom label names a residue that the structure does not have");
}

const Residue& residue_of(const Structure& structure, std::size_t atom) {
    static const Residue kNameless;
    return structure.residues.empty() ? kNameless : structure.residues[structure.labels[atom].residue];
}

}  // namespace meniscus
