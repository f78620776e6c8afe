// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Readers of lists of spheres: xyzr, xyzrn.
#pragma once

#include <string>
#include <string_view>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// xyzr: "x y z radius" per line; words behind are passed over. Blank lines and '#' comments are allowed.
/// throws   InputError with line and column
RawModel parse_xyzr(std::string_view text, const std::string& file);

/// xyzrn: "x y z radius flag name_residue_number" per line, as MSMS takes them; flag and name may be missing.
/// throws   as parse_xyzr
RawModel parse_xyzrn(std::string_view text, const std::string& file);

}  // namespace meniscus::reading
