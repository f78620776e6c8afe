// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/pdb_spheres.h"

#include <fmt/core.h>

#include <algorithm>
#include <cctype>

#include "dropins/strict_number.h"
#include "meniscus/errors.h"
#include "next_line.h"
#include "reading/text.h"

namespace meniscus::dropins {
namespace {

/// Columns first to last of a record, from 1 on, without blanks around.
std::string columns(const std::string& line, std::size_t first, std::size_t last) {
    if (line.size() < first) return "";
    const std::string text = line.substr(first - 1, last - first + 1);
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string::npos) return "";
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::string without_blanks(std::string text) {
    text.erase(std::remove(text.begin(), text.end(), ' '), text.end());
    return text;
}

bool is_letter(char c) { return std::isalpha(static_cast<unsigned char>(c)) != 0; }
char upper(char c) { return static_cast<char>(std::toupper(static_cast<unsigned char>(c))); }

double coordinate(const std::string& line, std::size_t first, const std::string& path, std::size_t number) {
    const std::string text = columns(line, first, first + 7);
    const auto value = strict_number(text);
    if (!value)
        throw InputError(fmt::format("{}:{}:{}: the coordinate {} is not a finite number; correct it", path, number,
                                     first, reading::shown(text)));
    return *value;
}

PdbRecord parse_record(const std::string& line, const std::string& path, std::size_t number) {
    PdbRecord record;
    record.centre = {coordinate(line, 31, path, number), coordinate(line, 39, path, number),
                     coordinate(line, 47, path, number)};
    record.names.name = without_blanks(columns(line, 13, 16));
    record.names.residue = without_blanks(columns(line, 18, 20));
    record.names.element = element_of(line.substr(12, 4), columns(line, 77, 78));
    record.number = without_blanks(columns(line, 23, 27));
    return record;
}

}  // namespace

std::string element_of(const std::string& name_columns, const std::string& element_columns) {
    std::string element;
    for (const char c : element_columns)
        if (is_letter(c)) element += upper(c);
    if (!element.empty()) return element;
    std::string name = name_columns;
    name.resize(4, ' ');
    std::transform(name.begin(), name.end(), name.begin(), upper);
    if (!is_letter(name[0])) return is_letter(name[1]) ? std::string(1, name[1]) : "";
    // Hydrogens with names of four letters begin in the first column: "HG11", "HO5'".
    if ((name[0] == 'H' || name[0] == 'D') && name[3] != ' ') return std::string(1, name[0]);
    return is_letter(name[1]) ? name.substr(0, 2) : std::string(1, name[0]);
}

std::vector<PdbRecord> read_pdb_records(std::istream& stream, const std::string& path) {
    std::vector<PdbRecord> records;
    std::size_t number = 0;
    for (std::string line; cli::next_line(stream, line, path, number + 1);) {
        ++number;
        if (line.starts_with("ENDMDL")) break;
        if (line.starts_with("ATOM  ") || line.starts_with("HETATM"))
            records.push_back(parse_record(line, path, number));
    }
    if (records.empty()) throw InputError(path + ": no ATOM or HETATM record; give a PDB file");
    return records;
}

std::string xyzr_line(const PdbRecord& record, double radius) {
    const auto& [x, y, z] = record.centre;
    return fmt::format("{:8.3f} {:8.3f} {:8.3f} {:4.2f}\n", x, y, z, radius);
}

std::string xyzrn_line(const PdbRecord& record, double radius) {
    const auto& [x, y, z] = record.centre;
    const auto word = [](const std::string& text) { return text.empty() ? std::string("-") : text; };
    return fmt::format("{:f} {:f} {:f} {:f} 1 {}_{}_{}\n", x, y, z, radius, word(record.names.name),
                       word(record.names.residue), word(record.number));
}

}  // namespace meniscus::dropins
