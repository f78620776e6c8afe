// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How much residues avoid water.
#pragma once

#include <optional>
#include <string_view>

namespace meniscus {

/// Kyte & Doolittle, J. Mol. Biol. 157, 1982, 105-132: -4.5 (ARG) to 4.5 (ILE); nothing for what is no standard
/// residue.
std::optional<double> hydropathy_of(std::string_view standard_residue);

}  // namespace meniscus
