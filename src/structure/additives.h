// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Small molecules that a crystal or a simulation is made of beside its molecule and that molecule's ligands.
#pragma once

#include <string_view>

namespace meniscus::reading {

/// True for a residue name of a buffer, a cryoprotectant, a precipitant, a salt, a solvent or a detergent of
/// crystallisation, or of a lipid of a simulated membrane. Any of them may be a true ligand somewhere.
///
/// source   those of the artefacts of crystallisation in BioLiP (Yang, Roy & Zhang, Nucleic Acids Res. 41, 2013,
///          D1096) that are hardly ever a ligand; lipids as CHARMM-GUI names them (Wu et al., J. Comput. Chem. 35,
///          2014, 1997)
bool is_additive(std::string_view residue);

}  // namespace meniscus::reading
