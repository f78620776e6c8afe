// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the walls of pockets are made of.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meniscus/pockets.h"
#include "meniscus/structure.h"

namespace meniscus {

/// The class of each atom of a structure, as the ranking of pockets needs them. Modified residues are read as their
/// parents (MSE as MET); atoms of other residues by their element.
std::vector<AtomClass> atom_classes(const Structure& structure);

/// Why the ranking of a structure's pockets is less sure than for what it was fitted to; empty if it is not.
///
/// spacing   PocketOptions::spacing
std::string doubt_of_ranking(const Structure& structure, double spacing);

/// An atom of a pocket's wall lines the pocket if its share of the wall is larger than this, Å².
inline constexpr double kLiningArea = 1.0;

/// What lines a pocket.
struct PocketChemistry {
    std::vector<std::uint32_t> atoms;     ///< lining atoms, ascending
    std::vector<std::uint32_t> residues;  ///< indices into Structure::residues of those that have one, ascending
    double hydrophobicity =
        0.0;                    ///< mean over the wall's area of Kyte and Doolittle's scale (4.5 for ILE, -4.5 for ARG)
    int charge = 0;             ///< e: lining ARG and LYS less lining ASP and GLU
    std::size_t donors = 0;     ///< lining atoms that give hydrogen bonds
    std::size_t acceptors = 0;  ///< lining atoms that take hydrogen bonds; hydroxyl groups are both
};

/// source   Kyte & Doolittle 1982, J. Mol. Biol. 157, 105-132
PocketChemistry describe_pocket(const Pocket& pocket, const Structure& structure);

}  // namespace meniscus
