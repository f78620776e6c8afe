// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Atoms that another program has read, chosen and given radii as if they came from a file.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meniscus/structure.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// An atom with what another program knows of it. What it does not know stays at its default.
struct NamedAtom {
    Vec3 centre;                 ///< Å
    std::string chain, residue;  ///< "A", "ALA"
    std::string name;            ///< "CA"
    std::string element;         ///< in any case; empty: the name tells it; "VS": a virtual site, which is left out
    int residue_number = 0;
    char insertion_code = ' ';
    char altloc = ' ';
    std::optional<bool> is_hetero{};  ///< in a HETATM record; empty: of residues other than amino acids and nucleotides
    bool in_polymer = false;          ///< the program says that the residue belongs to a polymer
    int serial = 0;
    double b_factor = 0.0;  ///< Å², or the pLDDT of a predicted model
    double occupancy = 1.0;
    double charge = 0.0;             ///< e
    std::optional<double> radius{};  ///< Å; used if all atoms have one
};

/// A structure and from which of the given atoms it was made.
struct StructureOfAtoms {
    Structure structure;
    std::vector<std::size_t> indices;  ///< of each kept atom, into the given atoms
};

/// The structure that read_structure() would make of a file with these atoms: the same radii, hydrogens, hetero groups,
/// waters, alternative locations and notes.
///
/// source    what messages call the other program, as in "MDTraj has no elements"
/// options   model, join_models and assembly must be left at their defaults
/// throws    InputError if no atoms are left; UsageError for an option that is not valid
/// cost      O(n log n)
StructureOfAtoms structure_of_atoms(std::span<const NamedAtom> atoms, const std::string& source,
                                    const ReadOptions& options = {});

}  // namespace meniscus
