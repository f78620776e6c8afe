// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A user's own radii: a text file of rules.
//
//   # RESIDUE  ATOM   RADIUS   one rule per line; the first that matches an atom decides
//   ASP        OD*    1.45     PREFIX* stands for all atoms whose names begin so
//   HEM,HEC    @FE    1.30     @EL is an element, NAME@EL an atom name and its element (CA@C is not calcium)
//   *          @C     1.70     * is any residue, or any atom
//   *          *      1.60
//   hydrogens  drop            optional: the radii stand for heavy atoms with their hydrogens
//
// Names are read without regard to case. A rule for HIS or CYS also applies to their variants (HSD, HIE, CYX ...), so
// a variant's own rule goes first. Radius 0 means that the atom does not exist for the surface.
#pragma once

#include <string>
#include <string_view>

#include "radii/radius_set.h"

namespace meniscus {

/// Reads rules from the text of a file; `file` is its name for messages and becomes the name of the set.
/// throws   InputError with line and column for anything that is not a rule, or if there is none
RadiusSet parse_radius_rules(std::string_view text, const std::string& file);

/// Reads a file of rules.
/// throws   InputError also if the file cannot be read
RadiusSet read_radius_rules(const std::string& path);

}  // namespace meniscus
