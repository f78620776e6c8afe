// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The records of a PDB file by their names, and what programs make of these: blanks in front, lower case.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace meniscus::reading {

/// True for ATOM and HETATM records, also if a serial number of six or seven digits reaches into the record's name.
bool is_atom_record(std::string_view line);

/// True for every record of the format, in any case and behind any blanks.
bool is_pdb_record(std::string_view line);

/// True for the name of a record of the format without its digits: TER, CRYST.
bool is_record_name(std::string_view letters);

/// For other formats with such records, a line without an atom of its own.
/// throws   InputError if an atom record begins within the line of END, TER, CONECT or MASTER
void check_joined_record(std::string_view line, std::size_t number, const std::string& file);

/// What was found about the names of records; a line per kind, with the number of the first line of the kind.
struct RecordOddities {
    std::vector<std::string> notes;
    std::vector<std::string> warnings;
};

/// Moves records that begin behind blanks to the first column and puts the names of records into capitals, so that
/// every reader of the text finds them. Lines keep their number and length.
///
/// Lines that may be atoms but have the name of no record are told in a warning.
/// throws   InputError for an atom record that begins within a line: files joined without a line end
RecordOddities tidy_records(std::string& text, const std::string& file);

}  // namespace meniscus::reading
