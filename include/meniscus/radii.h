// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Radii of atoms that come from elsewhere than a file.
#pragma once

#include <span>
#include <string>
#include <vector>

namespace meniscus {

/// What is known of an atom; any case. Empty where nothing is.
struct AtomNames {
    std::string residue;  ///< "ALA"
    std::string name;     ///< "CA"
    std::string element;  ///< symbol: "C", "Fe"
};

/// A van der Waals radius for every atom, Å.
///
/// Atoms that the set does not know get the radius of their element. Hydrogens get 0 from sets whose radii stand for
/// heavy atoms with their hydrogens (united, protor, naccess): leave them out. Unlike read_structure() this knows
/// neither disulfides nor charged amino ends; parse has other radii for the hydrogens there.
///
/// set      bondi (elements are enough), united, protor, naccess, parse, or the path of a file of rules
/// throws   UsageError for an unknown set, and for an atom of neither known name nor known element; InputError for a
///          file of rules that cannot be read
std::vector<double> radii_of(std::span<const AtomNames> atoms, const std::string& set);

}  // namespace meniscus
