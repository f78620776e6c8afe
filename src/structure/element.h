// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The element of an atom when only its name tells.
#pragma once

#include <string>
#include <string_view>

namespace meniscus::reading {

/// Element from the four name columns of a PDB file, blanks kept: " CA " is carbon, "CA  " calcium, but in an amino
/// acid or nucleotide any CA is carbon. residue is upper case without blanks.
/// returns  the symbol in upper case; empty if the name tells nothing
std::string element_from_columns(std::string_view name, std::string_view residue);

/// Element from a name without alignment (PQR, xyzrn, mmCIF without type_symbol).
std::string element_from_name(std::string_view name, std::string_view residue);

/// Element of the only atom of a residue that is an ion, because both have the same name but for digits and signs ("NA"
/// in NA2) or because the residue is named ION. residue is upper case without blanks.
/// returns  the symbol in upper case; empty if the names do not tell an ion
std::string element_of_ion(std::string_view name, std::string_view residue);

/// The symbol in upper case if the text is one (any case, blanks around it), else empty.
std::string element_symbol(std::string_view text);

/// True if an atom of this name (four columns) may be of an element of two letters: what element_from_columns tells, or
/// outside the standard residues a name that begins with the symbol, wherever it stands in its columns.
bool may_be_element(std::string_view name, std::string_view residue, std::string_view symbol);

std::string upper_case(std::string_view text);

}  // namespace meniscus::reading
