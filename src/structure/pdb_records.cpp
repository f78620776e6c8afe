// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_records.h"

#include <algorithm>
#include <array>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/odd_lines.h"
#include "structure/pdb_columns.h"

namespace meniscus::reading {
namespace {

// The most frequent ones first.
constexpr auto kRecords = std::to_array<std::string_view>({
    "ATOM  ", "HETATM", "ANISOU", "CONECT", "REMARK", "TER",    "HEADER", "OBSLTE", "TITLE ", "COMPND", "SOURCE",
    "KEYWDS", "EXPDTA", "AUTHOR", "REVDAT", "JRNL  ", "DBREF",  "SEQRES", "SEQADV", "MODRES", "HET   ", "HETNAM",
    "FORMUL", "HELIX ", "SHEET ", "SSBOND", "LINK  ", "CISPEP", "SITE  ", "CRYST1", "ORIGX",  "SCALE",  "MTRIX",
    "MODEL",  "ENDMDL", "MASTER", "NUMMDL", "SPLIT",  "CAVEAT", "USER",   "END",    "HETSYN", "SPRSDE", "SIGATM",
    "SIGUIJ", "MDLTYP", "FTNOTE", "TVECT ", "TURN  ", "HYDBND", "SLTBRG", "LINKR ",
});

// Those that decide which atoms there are and where models end.
constexpr auto kRead = std::to_array<std::string_view>({"ENDMDL", "END", "MODEL", "TER", "SEQRES"});

constexpr std::size_t kNameWidth = 6;

// What may stand in front of a record. A form feed begins a page of a printed listing.
constexpr std::string_view kBlanks = " \t\f\v";

// The first columns from the first character that is no blank, in capitals.
std::string record_name(std::string_view line, std::size_t indent) {
    std::string name = upper_case(line.substr(indent, kNameWidth));
    name.resize(kNameWidth, ' ');
    return name;
}

bool is_known(std::string_view name) {
    return std::any_of(kRecords.begin(), kRecords.end(), [&](std::string_view r) { return name.starts_with(r); });
}

std::size_t count_letters(std::string_view name) {
    return std::min(name.find_first_not_of("ABCDEFGHIJKLMNOPQRSTUVWXYZ"), name.size());
}

bool is_read(std::string_view name) {
    const std::string_view word = trimmed(name);
    return is_atom_record(name) || std::find(kRead.begin(), kRead.end(), word) != kRead.end() ||
           name.substr(0, count_letters(name)) == "MODEL";
}

// A byte behind the name of ATOM that leaves it a name.
bool may_follow_atom(char c) { return is_blank(c) || (c >= '0' && c <= '9') || c == '*' || c == '-'; }

// Records of anything but free text, so that an atom is seen behind them in their line.
bool may_be_the_last(std::string_view name) {
    constexpr auto kLast = std::to_array<std::string_view>(
        {"END", "TER", "CONECT", "MASTER", "ANISOU", "SIGATM", "SIGUIJ", "MODEL", "CRYST1", "ORIGX", "SCALE", "MTRIX"});
    return std::any_of(kLast.begin(), kLast.end(), [&](std::string_view r) { return name.starts_with(r); });
}

// Where ATOM or HETATM begins in any case, with a blank or the digits of its serial number behind it.
std::size_t find_atom_name(std::string_view line, std::size_t from) {
    for (std::size_t i = from; i + kNameWidth < line.size(); ++i) {
        if ((line[i] | 0x20) != 'a' && (line[i] | 0x20) != 'h') continue;
        const std::string name = upper_case(line.substr(i, kNameWidth + 1));
        const char behind = name[name.starts_with("HETATM") ? kNameWidth : 4];
        if (is_atom_record(name) && (is_blank(behind) || (behind >= '0' && behind <= '9'))) return i;
    }
    return std::string_view::npos;
}

// Where a file ends without a line end, and another was written behind it: "ENDATOM      1".
void refuse_joined(std::string_view line, std::size_t from, std::size_t number, const std::string& file) {
    const std::size_t place = find_atom_name(line, from);
    if (place == std::string_view::npos || !has_coordinates(line.substr(place))) return;
    fail_at(file, {number, place + 1},
            "an atom record begins within a line; put it on a line of its own, as where two files were joined");
}

// Whether a name stands between the first word and the first decimal, as in an atom; tables of energies, scores and
// matrices have numbers alone.
bool names_something(std::string_view line) {
    Words words(line);
    words.next();
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        if (std::any_of(word.begin(), word.end(), is_letter)) return true;
        if (word.find('.') != std::string_view::npos) return false;
    }
    return false;
}

class RecordTidier {
public:
    RecordTidier(std::string& text, const std::string& file) : text_(text), file_(file), lines_(text) {}

    RecordOddities run() {
        while (lines_.next()) read(lines_.line());
        RecordOddities found;
        lower_.tell("the name of a record in lower case, ", "; read as capitals", found.notes);
        moved_.tell("", ": a record behind blanks; read as if it began in the first column", found.warnings);
        unknown_.tell("", " is not a record of the PDB format, but the line has coordinates as an atom has; left out",
                      found.warnings);
        return found;
    }

private:
    void read(std::string_view line) {
        if (is_atom_record(line)) return check_joined(line, kRecordLength);
        const std::size_t indent = line.find_first_not_of(kBlanks);
        if (indent == std::string_view::npos) return;
        const std::string name = record_name(line, indent);
        if (may_be_the_last(name)) check_joined(line, indent + 1);
        if (is_read(name))
            tidy(line, indent, name);
        else if (!is_known(name) && has_coordinates(line) && names_something(line))
            unknown_.add(lines_.number(), Words(line).next());
    }

    void check_joined(std::string_view line, std::size_t shortest) const {
        if (line.size() <= shortest) return;
        refuse_joined(line, is_atom_record(line) ? kCoordinatesEnd : 1, lines_.number(), file_);
    }

    void tidy(std::string_view line, std::size_t indent, const std::string& name) {
        const std::string word = name.substr(0, count_letters(name));
        const std::string_view as_it_is = line.substr(indent, word.size());
        if (indent == 0 && as_it_is == word) return;
        if (indent > 0) moved_.add(lines_.number(), as_it_is);
        if (as_it_is != word) lower_.add(lines_.number(), as_it_is);
        char* const begin = &text_[lines_.begin()];
        // Only the name is out of place where the coordinates stand in their columns.
        if (has_usual_columns(line))
            std::fill_n(begin, indent + word.size(), ' ');
        else
            std::fill(std::rotate(begin, begin + indent, begin + line.size()), begin + line.size(), ' ');
        std::copy(word.begin(), word.end(), begin);
    }

    static constexpr std::size_t kRecordLength = 80;
    static constexpr std::size_t kCoordinatesEnd = 54;

    std::string& text_;
    const std::string& file_;
    Lines lines_;
    OddLines lower_;
    OddLines moved_;
    OddLines unknown_;
};

}  // namespace

bool is_atom_record(std::string_view line) {
    if (line.starts_with("HETATM")) return true;
    return line.starts_with("ATOM") && (line.size() == 4 || may_follow_atom(line[4]));
}

bool is_pdb_record(std::string_view line) {
    const std::size_t indent = std::min(line.find_first_not_of(kBlanks), line.size());
    const std::string name = record_name(line, indent);
    return is_known(name) || is_atom_record(name);
}

bool is_record_name(std::string_view letters) {
    return std::any_of(kRecords.begin(), kRecords.end(),
                       [&](std::string_view r) { return r.substr(0, count_letters(r)) == letters; });
}

void check_joined_record(std::string_view line, std::size_t number, const std::string& file) {
    const std::size_t indent = std::min(line.find_first_not_of(" \t"), line.size());
    if (may_be_the_last(record_name(line, indent))) refuse_joined(line, indent + 1, number, file);
}

RecordOddities tidy_records(std::string& text, const std::string& file) { return RecordTidier(text, file).run(); }

}  // namespace meniscus::reading
