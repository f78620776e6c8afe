// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Residues in lists.
#pragma once

#include <string>

#include "meniscus/structure.h"

namespace meniscus {

/// "A:SER 195", as reports have it.
inline std::string spaced_label(const Residue& residue) {
    std::string label = residue.chain + ":" + residue.name + " " + std::to_string(residue.number);
    if (residue.insertion_code != ' ') label += residue.insertion_code;
    return label;
}

}  // namespace meniscus
