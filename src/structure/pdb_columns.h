// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Whether the coordinates of a PDB record stand in their columns. A name or number that is too wide moves everything
// behind it, and what then stands in the columns of a coordinate may well be a number.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "reading/numbers.h"

namespace meniscus::reading {

/// True if all three coordinates seem to have a fourth decimal behind their columns: numbers of four decimals, moved by
/// one column, have their points where those of three decimals have them. An occupancy of 100.00 is no decimal.
inline bool has_fourth_decimals(std::string_view line) {
    const bool is_occupancy = line.size() > 57 && line[57] == '.';
    return line.size() > 54 && is_digit(line[38]) && is_digit(line[46]) && is_digit(line[54]) && !is_occupancy;
}

/// True if the decimal points of x, y and z stand in columns 35, 43 and 51, as in nearly every file, and no number
/// runs into x from the left.
inline bool has_usual_columns(std::string_view line) {
    return line.size() > 50 && line[34] == '.' && line[42] == '.' && line[50] == '.' &&
           (line[29] == ' ' || line[30] == ' ') && !has_fourth_decimals(line);
}

struct ColumnFault {
    std::size_t column = 1;  ///< from 1
    std::string message;
};

/// What is wrong with the columns of an atom record: they are shifted, or a number runs across two fields.
/// returns  nothing if every number that there is stands whole in its own columns, with any count of decimals
std::optional<ColumnFault> find_column_fault(std::string_view line);

/// True if a line has three numbers in a row that could be coordinates, wherever they stand.
bool has_coordinates(std::string_view line);

}  // namespace meniscus::reading
