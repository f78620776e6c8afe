// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which radius set, which hydrogens, and a radius for each kept atom.
#pragma once

#include <string>
#include <vector>

#include "meniscus/structure.h"
#include "radii/radius_set.h"
#include "structure/choose_atoms.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

struct AssignedRadii {
    std::string set;             ///< name of the set in use; "file" for the file's own
    std::vector<double> values;  ///< of Chosen::atoms, in their order, Å, > 0
};

/// Chooses the set and drops hydrogens as docs/conventions.md says, then types every atom.
///
/// Removes hydrogens that the set stands for and atoms of radius 0 from `chosen`, and adds what it did there.
/// throws   UsageError for an unknown set, for a set that does not go with --hydrogens keep, or for one that needs
///          names where there are none; InputError for an unknown type with strict_radii
AssignedRadii assign_radii(const RawModel& model, const ReadOptions& options, const std::string& file, Chosen& chosen);

}  // namespace meniscus::reading
