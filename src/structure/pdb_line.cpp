// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_line.h"

#include <charconv>
#include <cmath>

#include "core/largest_length.h"
#include "radii/aliases.h"
#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/pdb_columns.h"

namespace meniscus::reading {
namespace {

// Residues with names that are known whoever writes them.
bool is_well_known(std::string_view residue) {
    return is_amino_acid(residue) || is_nucleotide(residue) || is_water(residue);
}

std::string name_in(std::string_view columns) { return upper_case(trimmed(columns)); }

// Columns 18-22 hold a name of three letters and a chain of one or two, or, as MD programs write it, a name of four
// letters (TIP3, POPC) and a chain of one or none.
bool has_long_name(std::string_view columns, ChainWidth width) {
    if (columns[2] == ' ' || columns[3] == ' ') return false;
    const std::string four = name_in(columns.substr(0, 4));
    if (columns[4] == ' ' || is_water(four)) return true;
    if (width == ChainWidth::Two || columns[0] == ' ') return false;
    return is_well_known(four) || !is_well_known(name_in(columns.substr(0, 3)));
}

// Four columns; after 9999 A000 to ZZZZ, then a000 to zzzz.
std::optional<int> hybrid36_number(std::string_view columns) {
    constexpr int kBase = 36;
    constexpr int kLetters = 26;
    constexpr int kPerLetter = kBase * kBase * kBase;
    if (!is_letter(columns[0])) return integer(columns);
    const char first = is_capital(columns[0]) ? 'A' : 'a';
    int value = 10000 - 10 * kPerLetter + (first == 'A' ? 0 : kLetters * kPerLetter);
    int power = kPerLetter;
    for (const char c : columns) {
        const bool is_letter_digit = c >= first && c < first + kLetters;
        if (!is_letter_digit && !is_digit(c)) return std::nullopt;
        value += power * (is_letter_digit ? c - first + 10 : c - '0');
        power /= kBase;
    }
    return value;
}

// What VMD writes for numbers of more than four digits: the number in hexadecimal, or stars.
std::optional<int> vmd_number(std::string_view columns) {
    if (columns == "****") return 0;
    int value = 0;
    const auto [end, error] = std::from_chars(columns.data(), columns.data() + columns.size(), value, 16);
    const bool is_whole = error == std::errc() && end == columns.data() + columns.size();
    return is_whole && columns.size() == 4 && is_digit(columns[0]) ? std::optional(value) : std::nullopt;
}

// Whether a symbol of two letters stands in the columns beside those of the element, alone and with a capital first.
bool is_shifted_element(const AtomLine& line, int shift, std::string_view residue) {
    const std::string_view columns = element_columns(line, shift);
    if (columns.size() < 2 || !is_capital(columns[0]) || !is_letter(columns[1])) return false;
    const auto first = std::size_t{77} + static_cast<std::size_t>(shift);
    if (line.columns(first - 1, first - 1) != " " || is_letter(line.padded(first + 2, first + 2)[0])) return false;
    return may_be_element(line.padded(13, 16), residue, element_symbol(columns));
}

}  // namespace

AtomLine::AtomLine(std::string_view line, std::size_t number, const std::string& file)
    : line_(without_blank_end(line)), number_(number), file_(file) {}

bool AtomLine::is_hetatm() const { return line_.starts_with("HETATM"); }

std::string_view AtomLine::columns(std::size_t first, std::size_t last) const {
    if (first > line_.size()) return {};
    return line_.substr(first - 1, last - first + 1);
}

std::string AtomLine::padded(std::size_t first, std::size_t last) const {
    std::string text(columns(first, last));
    text.resize(last - first + 1, ' ');
    return text;
}

void AtomLine::fail(std::size_t column, const std::string& message) const {
    fail_at(file_, {number_, column}, message);
}

void AtomLine::check_columns() const {
    if (has_usual_columns(line_)) return;
    if (const auto fault = find_column_fault(line_)) fail(fault->column, fault->message);
}

void AtomLine::check_length() const {
    if (line_.size() >= kPdbCoordinatesEnd) return;
    fail(line_.size() + 1, "the record ends before the coordinates do (column 54); the file is cut off or damaged");
}

// Names go into messages, tables and pages; no format of structures has other characters in them.
void AtomLine::check_names() const {
    const std::size_t place = find_unprintable(columns(13, 27));
    if (place == std::string_view::npos) return;
    fail(13 + place, "a byte that is not a printable character in the names of an atom; correct it");
}

double AtomLine::coordinate(std::size_t first, char axis) const {
    const std::string_view field = columns(first, first + 7);
    const auto value = finite_number(field);
    if (value && std::abs(*value) <= kLargestLength) return *value;
    fail(first, std::string(1, axis) + " coordinate " + shown(field) +
                    (value ? " is more than 1e12 Å" : " is not a finite number") +
                    "; correct it or leave the atom out");
}

std::optional<double> AtomLine::optional_number(std::size_t first, std::size_t last, OddLines& odd) const {
    const std::string_view field = trimmed(columns(first, last));
    if (field.empty()) return std::nullopt;
    const auto value = finite_number(field);
    if (!value) odd.add(number_, field);
    return value;
}

ChainWidth chain_width_of_record(std::string_view line, ChainWidth known) {
    if (line.size() < 22 || known == ChainWidth::Two) return known;
    const bool has_two = line[20] != ' ' && line[21] != ' ';
    if (!has_two && (line[20] != ' ' || known == ChainWidth::One)) return known;
    if (!is_well_known(name_in(line.substr(17, 3))) || is_well_known(name_in(line.substr(17, 4))) == has_two)
        return known;
    return has_two ? ChainWidth::Two : ChainWidth::One;
}

ResidueColumns residue_columns(const AtomLine& line, ChainWidth width) {
    const std::string columns = line.padded(18, 22);
    if (!has_long_name(columns, width)) return {name_in(columns.substr(0, 3)), columns.substr(3, 2)};
    std::string name = name_in(columns.substr(0, 4));
    const bool is_told = columns[4] == ' ' || width != ChainWidth::Unknown || is_well_known(name);
    return {std::move(name), std::string(" ") + columns[4], !is_told};
}

std::string chain_of_record(std::string_view line, ChainWidth width) {
    const std::string no_file;
    return std::string(trimmed(residue_columns(AtomLine(line, 0, no_file), width).chain));
}

ResidueNumber residue_number(const AtomLine& line, OddLines& odd) {
    const std::string columns = line.padded(23, 28);
    const std::string_view four = std::string_view(columns).substr(0, 4);
    const char code = columns[4];
    const bool is_wide = is_digit(code);
    if (!is_wide && trimmed(four).empty()) return {0, code};
    const std::string shown_number = shown(trimmed(line.columns(23, code == ' ' ? 27 : 30)));
    if (code != ' ' && columns[5] != ' ')
        line.fail(23, "residue number " + shown_number +
                          " has no room in columns 23-27; begin with 1 again in another chain, or write mmCIF");
    const auto number = is_wide ? integer(line.columns(23, 27)) : hybrid36_number(four);
    if (number) return {*number, is_wide ? ' ' : code};
    const auto of_vmd = is_wide ? std::nullopt : vmd_number(four);
    if (!of_vmd)
        line.fail(23, "residue number " + shown_number +
                          " is not an integer; correct it, or write mmCIF if it is one of more than four digits");
    odd.add(line.number(), four);
    return {*of_vmd, code};
}

int element_shift(const AtomLine& line, std::string_view residue) {
    for (const int shift : {-1, 1})
        if (is_shifted_element(line, shift, residue)) return shift;
    return 0;
}

int charge_columns(const AtomLine& line, int shift, OddLines& odd) {
    const auto first = std::size_t{79} + static_cast<std::size_t>(shift);
    const std::string_view field = trimmed(line.columns(first, first + 1));
    if (field.empty()) return 0;
    const std::size_t signs = static_cast<std::size_t>(field.find('+') != field.npos || field.find('-') != field.npos);
    std::size_t digits = 0;
    int charge = 0;
    for (const char c : field) {
        if (!is_digit(c)) continue;
        ++digits;
        charge = c - '0';
    }
    if (digits + signs != field.size() || digits > 1) {
        odd.add(line.number(), field);
        return 0;
    }
    return field.find('-') != field.npos ? -charge : charge;
}

int serial_columns(const AtomLine& line) {
    // A serial of six or seven digits reaches into column 5 of ATOM, or into column 12.
    const std::size_t first = line.text().starts_with("ATOM") ? 5 : 7;
    return integer(line.columns(first, 12)).value_or(integer(line.columns(7, 11)).value_or(0));
}

}  // namespace meniscus::reading
