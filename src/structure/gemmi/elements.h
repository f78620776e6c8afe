// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What gemmi knows of elements.
#pragma once

#include <string>

namespace meniscus::reading {

/// How an element bonds.
struct Bonding {
    double radius = 0.0;  ///< Å, Cordero et al., Dalton Trans. 2008, 2832; 0.5 Å for what is no element
    bool is_metal = false;
    bool is_hydrogen = false;
};

/// symbol   in upper case; may be empty
Bonding bonding_of(const std::string& symbol);

}  // namespace meniscus::reading
