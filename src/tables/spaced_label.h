// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The label of a residue as reports of pockets have it.
#pragma once

#include <string>

#include "meniscus/structure.h"

namespace meniscus {

/// "A:SER 195".
inline std::string spaced_label(const Residue& residue) {
    std::string label = residue.chain + ":" + residue.name + " " + std::to_string(residue.number);
    if (residue.insertion_code != ' ') label += residue.insertion_code;
    return label;
}

}  // namespace meniscus
