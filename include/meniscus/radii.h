// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Van der Waals radii of atoms that the caller names, not a structure file.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace meniscus {

/// The names of an atom, in upper or lower case; a name that is not known is empty.
struct AtomNames {
    std::string residue;  ///< "ALA"
    std::string name;     ///< "CA"
    std::string element;  ///< symbol: "C", "Fe"
};

/// The van der Waals radius of every atom, Å, in the order of `atoms`.
///
/// Atoms that the set does not know get the radius of their element. Sets whose radii stand for heavy atoms with their
/// hydrogens (united, protor, naccess) give hydrogens a radius of 0: leave those atoms out of the surface. Disulfides
/// and charged amino termini, whose hydrogens have other radii in parse, are found by read_structure() only.
///
/// set      bondi (elements are enough), united, protor, naccess, parse, or the path of a file of rules
/// throws   UsageError for an unknown set, and for an atom of neither known name nor known element; InputError for a
///          file of rules that cannot be read
std::vector<double> radii_of(std::span<const AtomNames> atoms, const std::string& set);

}  // namespace meniscus
