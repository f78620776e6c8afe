// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From the ATOM and HETATM records of a PDB file to the lines that MSMS reads: one line per record.
#pragma once

#include <cstddef>
#include <istream>
#include <string>
#include <vector>

#include "meniscus/radii.h"
#include "meniscus/vec3.h"

namespace meniscus::dropins {

struct PdbRecord {
    Vec3 centre;
    AtomNames names;
    std::string number;  ///< of the residue, with its insertion code
};

/// The records of the first model, all of them: waters, hetero groups, every alternative location, hydrogens.
/// path     for messages
/// throws   InputError "FILE:LINE:COLUMN: ..."
std::vector<PdbRecord> read_pdb_records(std::istream& stream, const std::string& path);

/// The symbol of an element, from columns 77-78 or else from the name's four columns; upper case, may be empty.
std::string element_of(const std::string& name_columns, const std::string& element_columns);

/// "   12.703    4.973   10.746 1.40"
std::string xyzr_line(const PdbRecord& record, double radius);

/// "12.703000 4.973000 10.746000 1.400000 1 OXT_ASN_46"
std::string xyzrn_line(const PdbRecord& record, double radius);

}  // namespace meniscus::dropins
