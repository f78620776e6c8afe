// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The lines of a PQR file as words, also where programs that write fixed columns have left no blank between two.
#pragma once

#include <string_view>
#include <vector>

#include "structure/word_line.h"

namespace meniscus::reading {

/// What a line of a PQR file is by its first word.
enum class PqrLine {
    Atom,     ///< ATOM or HETATM, also with a serial number grown onto it, in any case
    Known,    ///< another record of PDB files and of programs that write PQR, a comment or a blank line
    Unknown,  ///< anything else
};

PqrLine kind_of_pqr_line(std::string_view line);

/// The words of an atom's line. Words that have grown together are cut: a serial number from its record, a name from
/// a known residue, and, in PDB2PQR's columns, whatever reaches over the end of a field.
std::vector<Word> pqr_words(std::string_view line);

/// The first word that is two numbers or more without a blank between them; null if none is.
const Word* find_grown_numbers(const std::vector<Word>& words);

/// Whether the name of an atom must be a name and a residue without a blank between them, since what follows is no
/// residue, or a chain.
bool has_grown_name(const std::vector<Word>& words);

/// Whether a line of no known record has so many words, or so many numbers, that it may be meant as an atom.
bool may_be_atom(std::string_view line);

}  // namespace meniscus::reading
