// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Readers of the formats that give a radius for each atom: PQR, xyzr, xyzrn.
#pragma once

#include <string>
#include <string_view>

#include "structure/raw_model.h"

namespace meniscus::reading {

/// PQR: ATOM and HETATM lines of blank-separated words, "ATOM serial name residue [chain] number x y z charge radius";
/// other records are passed over. Number and insertion code may be one word (27A).
/// throws   InputError with line and column
RawModel parse_pqr(std::string_view text, const std::string& file);

/// xyzr: "x y z radius" per line; words behind are passed over. Blank lines and '#' comments are allowed.
/// throws   as parse_pqr
RawModel parse_xyzr(std::string_view text, const std::string& file);

/// xyzrn: "x y z radius flag name_residue_number" per line, as MSMS takes them; flag and name may be missing.
/// throws   as parse_pqr
RawModel parse_xyzrn(std::string_view text, const std::string& file);

}  // namespace meniscus::reading
