// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Carbon monoxide as a ligand, for tests.
#pragma once

#include "meniscus/structure.h"

namespace meniscus::testing {

/// Along x, the carbon first.
inline Ligands carbon_monoxide(const Vec3& carbon) {
    Ligands ligands;
    ligands.centres = {carbon, carbon + Vec3{1.128, 0.0, 0.0}};
    ligands.labels.resize(2);
    ligands.labels[0].name = ligands.labels[0].element = "C";
    ligands.labels[1].name = ligands.labels[1].element = "O";
    ligands.residues = {{.chain = "A", .name = "CMO", .number = 7}};
    ligands.bonds = {{0, 1}};
    return ligands;
}

}  // namespace meniscus::testing
