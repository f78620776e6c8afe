// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The fields of an ATOM or HETATM record, each checked as it is read.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "structure/odd_lines.h"

namespace meniscus::reading {

inline constexpr std::size_t kPdbCoordinatesEnd = 54;  // column 54 is the last of z

/// An ATOM or HETATM line under examination; columns are those of the format, from 1.
class AtomLine {
public:
    AtomLine(std::string_view line, std::size_t number, const std::string& file);

    std::string_view text() const { return line_; }
    std::size_t number() const { return number_; }
    bool is_hetatm() const;

    std::string_view columns(std::size_t first, std::size_t last) const;

    /// The columns, filled up with blanks to their full width.
    std::string padded(std::size_t first, std::size_t last) const;

    [[noreturn]] void fail(std::size_t column, const std::string& message) const;

    void check_columns() const;
    void check_length() const;
    void check_names() const;

    double coordinate(std::size_t first, char axis) const;

    /// A field of no consequence for any surface; nothing if it is blank or no number.
    std::optional<double> optional_number(std::size_t first, std::size_t last, OddLines& odd) const;

private:
    std::string_view line_;
    std::size_t number_;
    const std::string& file_;
};

/// How many columns the names of a file's chains have: column 22, or 21 and 22 as well.
enum class ChainWidth { Unknown, One, Two };

/// What an atom record tells of it: amino acids, nucleotides and waters have names of three letters in columns 18-20,
/// so that column 21 is blank unless it belongs to the chain.
ChainWidth chain_width_of_record(std::string_view line, ChainWidth known);

struct ResidueColumns {
    std::string name;        ///< upper case
    std::string chain;       ///< two columns
    bool ambiguous = false;  ///< the file does not tell whether column 21 belongs to the residue or to the chain
};

ResidueColumns residue_columns(const AtomLine& line, ChainWidth width);

/// Name of the chain in an atom record; empty for a blank one.
std::string chain_of_record(std::string_view line, ChainWidth width);

struct ResidueNumber {
    int number = 0;
    char insertion_code = ' ';
};

/// Columns 23-27: an integer, of five digits if the last takes the place of the insertion code, or hybrid-36 (A000 is
/// 10000). A blank one is 0. VMD's hexadecimal numbers and stars (0) are odd.
ResidueNumber residue_number(const AtomLine& line, OddLines& odd);

/// -1 or 1 if columns 76-77 or 78-79 hold an element of two letters that agrees with the atom's name, of which only one
/// letter is in columns 77-78; otherwise 0.
int element_shift(const AtomLine& line, std::string_view residue);

/// Columns 77-78, or those beside them.
inline std::string_view element_columns(const AtomLine& line, int shift) {
    const auto first = std::size_t{77} + static_cast<std::size_t>(shift);
    return line.columns(first, first + 1);
}

/// "2+", "+2", "1-", "-1", "+", "0" or blank behind the element; a sign alone is no charge.
int charge_columns(const AtomLine& line, int shift, OddLines& odd);

int serial_columns(const AtomLine& line);

}  // namespace meniscus::reading
