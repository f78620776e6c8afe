// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Places for pockets by name: ligands, residues.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/pockets.h"
#include "meniscus/structure.h"

namespace meniscus {

/// A place at which a pocket is asked for, and the ligand that lies there.
struct NamedPlace {
    std::string name;  ///< "A:HEM 142" of a ligand; what was asked for elsewhere
    PocketPlace place;
    Atoms ligand;  ///< none beside residues of the molecule, and at a point
};

/// The places of a selection: a place for all selected atoms that belong to the molecule, and one for each ligand,
/// which is what is selected and does not belong to it. Residues whose atoms are closer than 2.1 Å are one ligand.
/// Single atoms (ions) are ligands only where nothing else is selected.
///
/// molecule    whose pockets are looked for
/// whole       read from the same file with all its hetero atoms; its atoms are where the molecule's are
/// reach       PocketPlace::reach
/// option      what messages call the option that holds the expression
/// throws      as select_atoms()
std::vector<NamedPlace> places_of_selection(const Structure& molecule, const Structure& whole,
                                            const std::string& expression, double reach,
                                            const std::string& option = "at");

/// How a ligand sits in a molecule.
struct LigandFit {
    std::size_t atoms = 0;
    std::size_t inside = 0;    ///< atoms whose centres lie inside the SES of the large probe
    double area = 0.0;         ///< SAS of the ligand alone, Å²
    double buried_area = 0.0;  ///< the part of it that the molecule takes from the probe, Å²
};

/// Areas are exact, of PocketOptions::probe.
LigandFit fit_ligand(const Atoms& molecule, const Atoms& ligand, const Pocket& pocket, double probe);

}  // namespace meniscus
