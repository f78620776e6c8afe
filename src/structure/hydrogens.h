// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Does a structure have its hydrogens?
#pragma once

#include <cstdint>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// Hydrogen or deuterium.
inline bool is_hydrogen(const RawAtom& atom) { return atom.element == "H" || atom.element == "D"; }

struct HydrogenCount {
    std::size_t all = 0;            ///< hydrogens among the kept atoms
    std::size_t in_polymer = 0;     ///< of the polymer, or of everything if no polymer is kept
    std::size_t protein_heavy = 0;  ///< heavy atoms that should have 7 hydrogens for 10
    std::size_t other_heavy = 0;    ///< those that should have 3 for 10

    bool is_complete() const { return all > 0 && 10 * in_polymer >= 7 * protein_heavy + 3 * other_heavy; }
};

/// Proteins have about one hydrogen per heavy atom, nucleic acids about 0.55; polar hydrogens alone make 0.2. The
/// limits are 0.7 and 0.3 (docs/conventions.md); 0.3 also where nothing of a polymer is kept.
HydrogenCount count_hydrogens(const RawModel& model, const std::vector<std::uint32_t>& kept);

}  // namespace meniscus::reading
