// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the tables of atoms say about each atom.
#pragma once

#include <cstddef>

#include "meniscus/structure.h"

namespace meniscus {

/// throws   UsageError unless there is one label and one radius per atom and every label names a residue that exists
///          (or there are no residues, as in a file of bare spheres)
void check_labels(const Structure& structure);

/// The residue of an atom; a nameless one if the structure has no residues.
const Residue& residue_of(const Structure& structure, std::size_t atom);

}  // namespace meniscus
