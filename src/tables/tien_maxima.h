// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The largest solvent-accessible area that each amino acid can have in a chain.
#pragma once

#include <optional>
#include <string_view>

namespace meniscus {

/// Å², theoretical maximum for probe 1.4 Å; nothing for other residues.
/// name     three letters, upper case, as the wwPDB writes it
/// source   M. Z. Tien, A. G. Meyer, D. K. Sydykova, S. J. Spielman, C. O. Wilke: Maximum allowed solvent
///          accessibilites of residues in proteins. PLoS ONE 8 (2013) e80635, table 1, column "Theoretical".
std::optional<double> tien_maximum(std::string_view name);

}  // namespace meniscus
