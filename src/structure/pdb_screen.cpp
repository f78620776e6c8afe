// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_screen.h"

#include <cstdint>
#include <type_traits>
#include <utility>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/odd_lines.h"
#include "structure/pdb_line.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kRecordLength = 80;

// Appends the record of a run's first atom as the parser gets it: full length, one-column chain layout, own serial.
void append_record(const AtomLine& line, const ResidueColumns& residue, std::string_view segment, std::size_t serial,
                   std::string& text) {
    const std::size_t begin = text.size();
    text += line.text().substr(0, kPdbCoordinatesEnd);
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

// Fields that hold what they should not, or stand where they should not, and can be read all the same.
struct OddFields {
    OddLines occupancy;
    OddLines b_factor;
    OddLines charge;
    OddLines element;
    OddLines residue;
    OddLines number;

    std::vector<std::string> told() const {
        std::vector<std::string> lines;
        occupancy.tell("occupancy ", " is not a number; taken as missing", lines);
        b_factor.tell("B factor ", " is not a number; taken as missing", lines);
        charge.tell("charge ", " is neither blank nor a digit and a sign; taken as missing", lines);
        element.tell("element ", " stands one column beside columns 77-78; read from where it stands", lines);
        residue.tell("", " in columns 18-22 is read as a residue name of four letters and a chain name of one", lines);
        number.tell("residue number ",
                    " is as VMD writes those above 9999, in hexadecimal or as stars (taken as 0); others may be "
                    "hexadecimal although they look decimal",
                    lines);
        return lines;
    }
};

// Takes the atoms of a model one by one.
class Screen {
public:
    Screen(CleanPdb& clean, ChainWidth width) : clean_(clean), width_(width) {}

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
        take_element(line, atom);
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
        ResidueColumns residue = residue_columns(line, width_);
        if (residue.ambiguous) odd_.residue.add(line.number(), line.columns(18, 22));
        append_record(line, residue, trimmed(segment_), clean_.runs.size() + 1, clean_.text);
        const ResidueNumber number = residue_number(line, odd_.number);
        clean_.runs.push_back({std::move(residue.name), printable(trimmed(segment_)), number});
    }

    // Text where the symbol belongs is an element only if it is a symbol.
    void take_element(const AtomLine& line, RawAtom& atom) {
        const int shift = element_shift(line, clean_.runs.back().residue);
        const std::string_view columns = element_columns(line, shift);
        if (shift != 0) odd_.element.add(line.number(), columns);
        atom.element = element_symbol(columns);
        atom.guessed_element = atom.element.empty();
        if (atom.guessed_element)
            atom.element = element_from_columns(line.padded(13, 16), clean_.runs.back().residue);
        else
            atom.charge = charge_columns(line, shift, odd_.charge);
    }

    CleanPdb& clean_;
    ChainWidth width_;
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
                "assembly operator: " + shown(word) + " is not a finite number; correct it or ask for no assembly");
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
    Screen screen(clean, model.chain_width);
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
