// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Selections in the words of PyMOL and VMD ("chain A and resi 10-50"), put into gemmi's syntax.
#pragma once

#include <string>

namespace meniscus::reading {

/// Whether a selection is written in words, as for PyMOL and VMD, and not in gemmi's syntax.
bool is_in_words(const std::string& expression);

/// The same selection in gemmi's syntax: "//A/10-50" for "chain A and resi 10-50" and "chain A and resid 10 to 50".
///
/// expression   one for which is_in_words() holds
/// option       named in messages
/// throws       UsageError with the right form for what cannot be put exactly: or, not, several ranges, protein, ...
std::string in_gemmi_syntax(const std::string& expression, const std::string& option);

}  // namespace meniscus::reading
