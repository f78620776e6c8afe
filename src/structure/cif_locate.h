// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where in an mmCIF file a value stands: parsers forget it, error messages need it.
#pragma once

#include <string_view>

#include "reading/text.h"

namespace meniscus::reading {

/// The place of a tag's value: of the row'th (from 0) value in a loop, or of the only value of a pair.
///
/// tag      compared without regard to case
/// returns  the place of the first such value in the text; line 1, column 1 if there is none
/// Precondition: the text is valid CIF.
Place locate_cif_value(std::string_view text, std::string_view tag, std::size_t row);

}  // namespace meniscus::reading
