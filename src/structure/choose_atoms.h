// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From all atoms of a model to those that are kept, with an account of the others.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "meniscus/structure.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Atoms of a model that stay, and what became of the others.
struct Chosen {
    std::vector<std::uint32_t> atoms;            ///< indices into RawModel::atoms, in file order
    std::vector<std::uint32_t> ligands_drawn;    ///< atoms of Structure::ligands, in file order, left out or not
    bool ligands_stay = false;                   ///< they are among `atoms`
    std::map<std::string, std::size_t> dropped;  ///< atoms left out, by reason
    std::map<std::string, std::size_t> ligands;  ///< residues of ligands left out, by name
    std::vector<std::string> notes;              ///< see Structure::notes, one line per kind
    std::vector<std::string> warnings;           ///< see Structure::warnings, one line per kind

    /// Counts atoms left out for a reason; none is not mentioned.
    void drop(const std::string& reason, std::size_t count) {
        if (count > 0) dropped[reason] += count;
    }
};

/// Applies --chains, --select, --altloc, --waters and --hetero, in this order. Kinds of residues must be set.
/// A model with radii of its own (PQR, xyzr) loses waters and hetero atoms only if options.keep_waters or
/// options.hetero is given; waters that are kept because it is not are a warning.
///
/// throws   InputError for a chain that does not exist; UsageError for a selection that is not valid
Chosen choose_atoms(const RawModel& model, const ReadOptions& options, const std::string& file);

}  // namespace meniscus::reading
