// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_screen.h"

#include <algorithm>
#include <optional>
#include <type_traits>
#include <utility>

#include "radii/aliases.h"
#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kRecordLength = 80;
constexpr std::size_t kCoordinatesEnd = 54;  // column 54 is the last of z

// Whether a few columns hold nothing but digits with a point and perhaps a minus sign, as coordinates do: a finite
// number, which need not be found to know that. Others may be numbers, too.
bool is_plain_decimal(std::string_view field) {
    field = trimmed(field);
    if (field.starts_with('-')) field.remove_prefix(1);
    const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
    const auto* const point = std::find_if_not(field.begin(), field.end(), is_digit);
    return field.size() > 1 && point != field.end() && *point == '.' && std::all_of(point + 1, field.end(), is_digit);
}

// An ATOM or HETATM line under examination; columns are those of the format, from 1.
class AtomLine {
public:
    AtomLine(std::string_view line, std::size_t number, const std::string& file)
        : line_(without_blank_end(line)), number_(number), file_(file) {}

    std::string_view columns(std::size_t first, std::size_t last) const {
        if (first > line_.size()) return {};
        return line_.substr(first - 1, last - first + 1);
    }

    // The columns, filled up with blanks to their full width.
    std::string padded(std::size_t first, std::size_t last) const {
        std::string text(columns(first, last));
        text.resize(last - first + 1, ' ');
        return text;
    }

    std::string_view text() const { return line_; }

    [[noreturn]] void fail(std::size_t column, const std::string& message) const {
        fail_at(file_, {number_, column}, message);
    }

    void check_length() const {
        if (line_.size() >= kCoordinatesEnd) return;
        const std::size_t tab = line_.find('\t');
        if (tab != std::string_view::npos) fail(tab + 1, "a tab in an atom record; the PDB format has fixed columns");
        fail(line_.size() + 1, "the record ends before the coordinates do (column 54); the file is cut off or damaged");
    }

    // Names go into messages, tables and pages; no format of structures has other characters in them.
    void check_names() const {
        const std::size_t place = find_unprintable(columns(13, 27));
        if (place == std::string_view::npos) return;
        fail(13 + place, "a byte that is no printable character among the names of an atom; correct it");
    }

    void check_coordinate(std::size_t first, char axis) const {
        const std::string_view field = columns(first, first + 7);
        if (is_plain_decimal(field) || finite_number(field)) return;
        fail(first, std::string(1, axis) + " coordinate " + shown(field) +
                        " is not a finite number; correct it or leave the atom out");
    }

    double optional_number(std::size_t first, std::size_t last, double otherwise, const char* what) const {
        const std::string_view field = trimmed(columns(first, last));
        if (field.empty()) return otherwise;
        const auto value = finite_number(field);
        if (!value) fail(first, std::string(what) + " " + shown(field) + " is not a finite number; blank is allowed");
        return *value;
    }

private:
    std::string_view line_;
    std::size_t number_;
    const std::string& file_;
};

struct ResidueColumns {
    std::string name;
    std::string chain;  // two columns
};

// Columns 18-22 hold a name of three letters and a chain of one or two, or, as MD programs write it, a name of four
// letters (TIP3, POPC) and a chain of one or none.
ResidueColumns residue_columns(const AtomLine& line) {
    const std::string columns = line.padded(18, 22);
    const std::string four = upper_case(trimmed(columns.substr(0, 4)));
    const bool is_long_name = columns[3] != ' ' && columns[2] != ' ' && (columns[4] == ' ' || is_water(four));
    if (is_long_name) return {four, std::string(" ") + columns[4]};
    return {upper_case(trimmed(columns.substr(0, 3))), columns.substr(3, 2)};
}

// Atoms of a residue follow each other: its columns are read anew where they change.
class ResidueReader {
public:
    const ResidueColumns& read(const AtomLine& line) {
        const std::string_view columns = line.columns(18, 22);
        if (columns != columns_) residue_ = residue_columns(line);
        columns_ = columns;
        return residue_;
    }

private:
    std::string_view columns_;
    ResidueColumns residue_;
};

// Old files have an entry name and a line number in columns 73-80: text there is an element only if it is a symbol.
std::string element_columns(const AtomLine& line) {
    const std::string_view field = line.columns(77, 78);
    // Right-justified as it should be, or alone in its columns; "N  " of a longer text does not get here.
    return element_symbol(field);
}

// "2+", "+2", "1-", "+", "0" or blank.
void check_charge(const AtomLine& line) {
    const std::string_view field = trimmed(line.columns(79, 80));
    const std::size_t signs = static_cast<std::size_t>(field.find('+') != field.npos || field.find('-') != field.npos);
    std::size_t digits = 0;
    for (const char c : field) digits += static_cast<std::size_t>(c >= '0' && c <= '9');
    if (digits + signs != field.size() || digits > 1) {
        line.fail(79, "charge " + shown(field) + " is neither blank nor a digit and a sign; clear columns 79-80");
    }
}

int serial_columns(const AtomLine& line) {
    // A serial of six digits reaches into column 6 of ATOM, or into column 12.
    const std::size_t first = line.text().starts_with("ATOM") ? 5 : 7;
    return integer(line.columns(first, 12)).value_or(integer(line.columns(7, 11)).value_or(0));
}

// `element` is that of its columns.
PdbAtomExtra read_extra(const AtomLine& line, const ResidueColumns& residue, std::string element, CleanPdb& clean) {
    PdbAtomExtra extra;
    extra.residue = residue.name;
    extra.segment = printable(trimmed(line.columns(73, 76)));
    extra.element = std::move(element);
    if (extra.element.empty()) {
        extra.element = element_from_columns(line.padded(13, 16), residue.name);
        ++clean.guessed_elements;
    } else {
        check_charge(line);
    }
    extra.serial = serial_columns(line);
    extra.occupancy = line.optional_number(55, 60, 1.0, "occupancy");
    extra.b_factor = line.optional_number(61, 66, 0.0, "B factor");
    extra.hetatm = line.text().starts_with("HETATM");
    return extra;
}

// Appends the record as the parser gets it: full length, one-column chain layout, own serial, known element.
void append_record(const AtomLine& line, const ResidueColumns& residue, const PdbAtomExtra& extra, bool has_element,
                   CleanPdb& clean) {
    const std::size_t begin = clean.text.size();
    clean.text += line.text().substr(0, kRecordLength);
    clean.text.resize(begin + kRecordLength, ' ');
    const auto put = [&](std::size_t column, std::string_view text) {
        text.copy(&clean.text[begin + column - 1], text.size());
    };
    const auto put_to_the_right = [&](std::size_t last, std::string_view text) { put(last + 1 - text.size(), text); };
    put(1, extra.hetatm ? "HETATM" : "ATOM  ");
    put(7, hybrid36_serial(clean.atoms.size() + 1));
    put(12, " ");
    put(18, "   ");
    put_to_the_right(20, std::string_view(residue.name).substr(0, 3));
    put(21, residue.chain);
    put(28, "   ");
    put(67, "          ");
    put(77, " ");
    put_to_the_right(78, extra.element.empty() ? "X" : extra.element);
    if (!has_element) put(79, "  ");
    clean.text += '\n';
}

void screen_atom(const AtomLine& line, ResidueReader& residues, CleanPdb& clean) {
    line.check_length();
    line.check_names();
    line.check_coordinate(31, 'x');
    line.check_coordinate(39, 'y');
    line.check_coordinate(47, 'z');
    const ResidueColumns& residue = residues.read(line);
    std::string element = element_columns(line);
    const bool has_element = !element.empty();
    PdbAtomExtra extra = read_extra(line, residue, std::move(element), clean);
    append_record(line, residue, extra, has_element, clean);
    clean.atoms.push_back(std::move(extra));
}

std::string padded_line(std::string_view line) {
    std::string padded(line.substr(0, kRecordLength));
    padded.resize(kRecordLength, ' ');
    return padded + "\n";
}

// The three rows of an operator must be numbers, or the copies would land anywhere.
void check_operator(std::string_view line, std::size_t number, const std::string& file) {
    if (line.substr(0, 18) != "REMARK 350   BIOMT" || line.size() < 24) return;
    Words words(line.substr(23));
    for (int i = 0; i < 4; ++i) {
        const std::string_view word = words.next();
        if (finite_number(word)) continue;
        fail_at(file, {number, 23 + words.column()},
                "assembly operator: " + shown(word) + " is not a finite number; correct it or drop --assembly");
    }
}

// Sequence and assemblies stand outside the models.
std::string clean_header(std::string_view text, const std::string& file, bool with_assemblies) {
    std::string header;
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (line.starts_with("SEQRES")) header += padded_line(line);
        if (!with_assemblies || !line.starts_with("REMARK 350")) continue;
        check_operator(line, lines.number(), file);
        header += padded_line(line);
    }
    return header;
}

}  // namespace

bool is_atom_record(std::string_view line) {
    return line.starts_with("HETATM") || line.starts_with("ATOM ") || line.starts_with("ATOM\t") || line == "ATOM";
}

std::string hybrid36_serial(std::size_t n) {
    constexpr std::size_t kDecimal = 100000;
    constexpr std::size_t kFirstUpper = 16796160;  // "A0000" in base 36
    std::string text(5, ' ');
    const auto write = [&text]<std::size_t kBase>(std::size_t rest, std::integral_constant<std::size_t, kBase>) {
        for (std::size_t i = text.size(); i-- > 0 && (rest > 0 || i + 1 == text.size()); rest /= kBase)
            text[i] = "0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ"[rest % kBase];
    };
    if (n < kDecimal)
        write(n, std::integral_constant<std::size_t, 10>());
    else
        write(n - kDecimal + kFirstUpper, std::integral_constant<std::size_t, 36>());
    return text;
}

CleanPdb screen_pdb(std::string_view text, const PdbModelSpan& model, const std::string& file, bool with_assemblies) {
    CleanPdb clean;
    clean.text = clean_header(text, file, with_assemblies);
    clean.text.reserve(clean.text.size() + (model.end - model.begin) + (model.end - model.begin) / 8);
    clean.atoms.reserve(model.atoms);
    ResidueReader residues;
    Lines lines(text.substr(model.begin, model.end - model.begin));
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (is_atom_record(line)) {
            screen_atom(AtomLine(line, model.first_line + lines.number() - 1, file), residues, clean);
        } else if (line.starts_with("TER")) {
            clean.text += "TER\n";
        }
    }
    return clean;
}

}  // namespace meniscus::reading
