// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// PDB and PQR told apart by what is in them. Both have ATOM records; where PDB has occupancy and B factor, PQR has
// charge and radius, and one read as the other gives wrong radii for every atom.
#pragma once

#include <string_view>

namespace meniscus::reading {

/// True if a text with ATOM records can only be PQR: every atom has the words of PQR, none has occupancy and B factor
/// in their columns, and charges and radii are plausible; or a remark of GROMACS says that radii are in the columns of
/// PDB. cost     that of the lines up to the first atom for a PDB file
bool is_surely_pqr(std::string_view text);

/// True if a text that is named PQR can only be PDB: most atoms have occupancy and B factor in their columns, and as
/// radii the B factors make no sense.
bool is_surely_pdb(std::string_view text);

}  // namespace meniscus::reading
