// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdbqt_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/gemmi/gemmi_reader.h"

namespace meniscus::reading {
namespace {

struct AtomType {
    std::string_view type;
    std::string_view element;  // empty: no atom
};

// AutoDock's types that are no symbols, or not of the element that they seem to be; they differ by case (NA is a
// nitrogen that accepts hydrogen bonds, Na is sodium).
constexpr auto kTypes = std::to_array<AtomType>({
    {"A", "C"},   {"NA", "N"}, {"NS", "N"}, {"NX", "N"}, {"OA", "O"},  {"OS", "O"},  {"OX", "O"},
    {"HD", "H"},  {"HS", "H"}, {"SA", "S"}, {"W", "O"},  {"CG0", "C"}, {"CG1", "C"}, {"CG2", "C"},
    {"CG3", "C"}, {"G", ""},   {"GA", ""},  {"G0", ""},  {"G1", ""},   {"G2", ""},   {"G3", ""},
    {"J", ""},    {"Q", ""},   {"Z", ""},   {"TZ", ""},  {"L", ""},
});

// What stands behind the columns that PDBQT shares with PDB.
struct PdbqtTail {
    double charge = 0.0;
    std::string_view type;
};

std::optional<PdbqtTail> pdbqt_tail(std::string_view line) {
    constexpr std::size_t kCharge = 66;  // column 67
    constexpr std::size_t kType = 77;    // column 78
    if (line.size() <= kType || line[kType - 1] != ' ') return std::nullopt;
    const std::string_view field = line.substr(kCharge, kType - 1 - kCharge);
    const auto charge = finite_number(field);
    const std::string_view type = without_blank_end(line.substr(kType));
    const bool is_type = !type.empty() && type.size() <= 3 && find_unprintable(type) == std::string_view::npos &&
                         upper_case(type)[0] >= 'A' && upper_case(type)[0] <= 'Z';
    if (!charge || field.find('.') == std::string_view::npos || !is_type) return std::nullopt;
    return PdbqtTail{*charge, type};
}

std::string element_of_type(std::string_view type) {
    const auto* known = std::find_if(kTypes.begin(), kTypes.end(), [&](const AtomType& t) { return t.type == type; });
    return known == kTypes.end() ? element_symbol(type) : std::string(known->element);
}

bool stands_for_no_atom(std::string_view type) {
    return std::any_of(kTypes.begin(), kTypes.end(),
                       [&](const AtomType& t) { return t.type == type && t.element.empty(); });
}

// The same line with the element where PDB has it; the columns before stay, and so do places in messages.
std::string as_pdb_line(std::string_view line, std::string_view type) {
    constexpr std::size_t kShared = 66;
    constexpr std::size_t kElementEnd = 78;
    std::string pdb(line.substr(0, kShared));
    const std::string element = element_of_type(type);
    pdb.resize(kElementEnd - element.size(), ' ');
    return pdb + element;
}

// A model as PDB text of as many lines, with what that has no room for.
class PdbText {
public:
    explicit PdbText(std::string_view pdbqt) {
        Lines lines(pdbqt);
        while (lines.next()) {
            take(lines.line());
            text_ += '\n';
        }
    }

    const std::string& text() const { return text_; }

    void complete(RawModel& model) const {
        for (std::size_t i = 0; i < model.atoms.size(); ++i)
            if (charges_.at(i)) model.atoms[i].charge = *charges_[i];
        if (left_out_ > 0)
            model.notes.push_back(std::to_string(left_out_) + " of AutoDock's atom types that stand for no atom (" +
                                  first_left_out_ + ") left out");
    }

private:
    void take(std::string_view line) {
        const bool is_atom = is_atom_record(line);
        const auto tail = is_atom ? pdbqt_tail(line) : std::nullopt;
        if (tail && stands_for_no_atom(tail->type)) {
            if (left_out_++ == 0) first_left_out_ = tail->type;
            return;
        }
        if (is_atom) charges_.push_back(tail ? std::optional(tail->charge) : std::nullopt);
        text_ += tail ? as_pdb_line(line, tail->type) : std::string(line);
    }

    std::string text_;
    std::vector<std::optional<double>> charges_;  // of the atoms, where they have one
    std::size_t left_out_ = 0;
    std::string first_left_out_;
};

}  // namespace

bool has_pdbqt_atoms(std::string_view text) {
    Lines lines(text);
    while (lines.next())
        if (is_atom_record(lines.line()) && pdbqt_tail(lines.line())) return true;
    return false;
}

RawModel parse_pdbqt(std::string_view text, const PdbModelSpan& model, const std::string& file) {
    const PdbText pdb(text.substr(model.begin, model.end - model.begin));
    PdbModelSpan whole = model;
    whole.begin = 0;
    whole.end = pdb.text().size();
    RawModel result = parse_pdb(screen_pdb(pdb.text(), whole, file, false), file);
    pdb.complete(result);
    return result;
}

}  // namespace meniscus::reading
