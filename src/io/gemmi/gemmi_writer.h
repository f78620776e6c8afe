// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// PDB and mmCIF as text. gemmi_writer.cpp is the only file that includes gemmi's writers, which compile slowly.
#pragma once

#include <string>
#include <vector>

#include "meniscus/structure.h"

namespace meniscus {

/// A structure in PDB format, values in the B-factor column. Precondition: everything fits its columns.
std::string pdb_text(const Structure& structure, const std::vector<double>& values);

/// A structure in mmCIF format, values as B_iso_or_equiv with six digits.
std::string mmcif_text(const Structure& structure, const std::vector<double>& values);

}  // namespace meniscus
