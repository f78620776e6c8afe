// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The many names that programs give to the same residue or atom.
#pragma once

#include <string>
#include <string_view>

namespace meniscus {

struct CanonicalNames {
    std::string residue;
    std::string atom;
};

/// Names as the wwPDB writes them: HSD and HIE become HIS, CYX becomes CYS, OT2 becomes OXT, ILE CD becomes CD1,
/// C5* becomes C5', O1P becomes OP1. Names without an alias come back unchanged. Input is upper case.
CanonicalNames canonical_names(std::string_view residue, std::string_view atom);

/// One of the 20 amino acids under any common name, SEC, PYL, MSE, UNK, or a blocking group (ACE, NME, NH2).
bool is_amino_acid(std::string_view residue);

/// One of the nucleotides of DNA and RNA under any common name.
bool is_nucleotide(std::string_view residue);

/// Water under any name that programs use (HOH WAT DOD H2O TIP3 SOL SPC ...), whatever the record.
bool is_water(std::string_view residue);

}  // namespace meniscus
