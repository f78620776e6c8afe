// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The columns of tables that say which atom, residue or chain a row is about.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "meniscus/tables.h"

namespace meniscus {

/// throws   UsageError unless the structure has this many atoms and a label for each
void check_match(const Structure& structure, std::size_t atoms);

/// The residue of an atom; a nameless one if the structure has no residues.
const Residue& residue_at(const Structure& structure, std::size_t atom);

/// Names and cells of the columns that identify a row; those of an atom are named as in NAME.atoms.csv.
std::vector<std::string> identity_columns(RowsPer per);
std::vector<Cell> atom_identity(const Structure& structure, std::size_t atom);
std::vector<Cell> residue_identity(const Residue& residue);

/// Adds cells at the end of a row. (GCC 12 warns of uninitialised text in lists of cells.)
template <class... Cells>
void add_cells(std::vector<Cell>& row, Cells&&... cells) {
    (row.emplace_back(std::forward<Cells>(cells)), ...);
}

/// A whole number as a cell.
Cell count_cell(std::size_t n);

}  // namespace meniscus
