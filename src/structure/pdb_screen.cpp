// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_screen.h"

#include <cstdint>
#include <optional>
#include <type_traits>
#include <utility>

#include "radii/aliases.h"
#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/odd_lines.h"
#include "structure/pdb_columns.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kRecordLength = 80;
constexpr std::size_t kCoordinatesEnd = 54;  // column 54 is the last of z

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

    bool is_hetatm() const { return line_.starts_with("HETATM"); }

    std::size_t number() const { return number_; }

    [[noreturn]] void fail(std::size_t column, const std::string& message) const {
        fail_at(file_, {number_, column}, message);
    }

    void check_columns() const {
        if (has_usual_columns(line_)) return;
        if (const auto fault = find_column_fault(line_)) fail(fault->column, fault->message);
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
        fail(13 + place, "a byte that is not a printable character in the names of an atom; correct it");
    }

    double coordinate(std::size_t first, char axis) const {
        const std::string_view field = columns(first, first + 7);
        if (const auto value = finite_number(field)) return *value;
        fail(first, std::string(1, axis) + " coordinate " + shown(field) +
                        " is not a finite number; correct it or leave the atom out");
    }

    // A field of no consequence for any surface; nothing if it is blank or no number.
    std::optional<double> optional_number(std::size_t first, std::size_t last, OddLines& odd) const {
        const std::string_view field = trimmed(columns(first, last));
        if (field.empty()) return std::nullopt;
        const auto value = finite_number(field);
        if (!value) odd.add(number_, field);
        return value;
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

// Old files have an entry name and a line number in columns 73-80: text there is an element only if it is a symbol.
std::string element_columns(const AtomLine& line) {
    const std::string_view field = line.columns(77, 78);
    // Right-justified as it should be, or alone in its columns; "N  " of a longer text does not get here.
    return element_symbol(field);
}

// "2+", "+2", "1-", "+", "0" or blank; a sign alone is no charge.
int charge_columns(const AtomLine& line, OddLines& odd) {
    const std::string_view field = trimmed(line.columns(79, 80));
    if (field.empty()) return 0;
    const std::size_t signs = static_cast<std::size_t>(field.find('+') != field.npos || field.find('-') != field.npos);
    std::size_t digits = 0;
    int charge = 0;
    for (const char c : field) {
        if (c < '0' || c > '9') continue;
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

// Appends the record of a run's first atom as the parser gets it: full length, one-column chain layout, own serial.
void append_record(const AtomLine& line, const ResidueColumns& residue, std::string_view segment, std::size_t serial,
                   std::string& text) {
    const std::size_t begin = text.size();
    text += line.text().substr(0, kCoordinatesEnd);
    text.resize(begin + kRecordLength, ' ');
    const auto put = [&](std::size_t column, std::string_view field) {
        field.copy(&text[begin + column - 1], field.size());
    };
    put(1, line.is_hetatm() ? "HETATM" : "ATOM  ");
    put(7, hybrid36_serial(serial));
    put(12, " ");
    put(18, "   ");
    const std::string_view name = std::string_view(residue.name).substr(0, 3);
    put(21 - name.size(), name);
    put(21, residue.chain);
    put(28, "   ");
    put(73, segment);
    text += '\n';
}

// Fields that hold what they should not, without harm to any result.
struct OddFields {
    OddLines occupancy;
    OddLines b_factor;
    OddLines charge;

    std::vector<std::string> told() const {
        std::vector<std::string> lines;
        occupancy.tell("occupancy ", " is not a number; taken as missing", lines);
        b_factor.tell("B factor ", " is not a number; taken as missing", lines);
        charge.tell("charge ", " is neither blank nor a digit and a sign; taken as missing", lines);
        return lines;
    }
};

// Takes the atoms of a model one by one.
class Screen {
public:
    explicit Screen(CleanPdb& clean) : clean_(clean) {}

    void take(const AtomLine& line) {
        line.check_columns();
        line.check_length();
        line.check_names();
        RawAtom atom;
        atom.centre = {line.coordinate(31, 'x'), line.coordinate(39, 'y'), line.coordinate(47, 'z')};
        if (clean_.runs.empty() || line.columns(18, 27) != residue_ || line.columns(73, 76) != segment_)
            begin_run(line);
        atom.residue = static_cast<std::uint32_t>(clean_.runs.size() - 1);
        atom.name = upper_case(trimmed(line.columns(13, 16)));
        atom.altloc = line.columns(17, 17).front();
        atom.hetatm = line.is_hetatm();
        atom.element = element_columns(line);
        if (atom.element.empty()) {
            atom.element = element_from_columns(line.padded(13, 16), clean_.runs.back().residue);
            atom.guessed_element = true;
        } else {
            atom.charge = charge_columns(line, odd_.charge);
        }
        atom.serial = serial_columns(line);
        atom.occupancy = line.optional_number(55, 60, odd_.occupancy).value_or(atom.occupancy);
        atom.b_factor = line.optional_number(61, 66, odd_.b_factor).value_or(atom.b_factor);
        clean_.atoms.push_back(std::move(atom));
    }

    void finish() { clean_.warnings = odd_.told(); }

private:
    void begin_run(const AtomLine& line) {
        residue_ = line.columns(18, 27);
        segment_ = line.columns(73, 76);
        ResidueColumns residue = residue_columns(line);
        append_record(line, residue, trimmed(segment_), clean_.runs.size() + 1, clean_.text);
        clean_.runs.push_back({std::move(residue.name), printable(trimmed(segment_))});
    }

    CleanPdb& clean_;
    OddFields odd_;
    std::string_view residue_;  // of the last atom
    std::string_view segment_;
};

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

std::string chain_of_record(std::string_view line) {
    const std::string no_file;
    return std::string(trimmed(residue_columns(AtomLine(line, 0, no_file)).chain));
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
    clean.atoms.reserve(model.atoms);
    Screen screen(clean);
    Lines lines(text.substr(model.begin, model.end - model.begin));
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (is_atom_record(line)) {
            screen.take(AtomLine(line, model.first_line + lines.number() - 1, file));
        } else if (line.starts_with("TER")) {
            clean.text += "TER\n";
        }
    }
    screen.finish();
    return clean;
}

}  // namespace meniscus::reading
