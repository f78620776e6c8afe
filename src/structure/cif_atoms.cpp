// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/cif_atoms.h"

#include <algorithm>
#include <cmath>

#include "core/largest_length.h"
#include "meniscus/errors.h"
#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/cif_locate.h"
#include "structure/element.h"

namespace meniscus::reading {
namespace {

// The number in front of a standard uncertainty in its last digits: "1.0" of "1.0(2)".
std::string_view without_uncertainty(std::string_view text) {
    if (text.empty() || text.back() != ')') return text;
    const std::size_t open = text.find('(');
    const std::string_view digits = text.substr(open + 1, text.size() - open - 2);
    const bool is_one = !digits.empty() && digits.find_first_not_of("0123456789") == std::string_view::npos;
    return open != std::string_view::npos && is_one ? text.substr(0, open) : text;
}

// "Zn" of "Zn2+", "Cl" of "Cl-"; the text itself if no charge follows.
std::string_view without_charge(std::string_view text) {
    const std::size_t last = text.find_last_not_of("0123456789+-");
    if (last == std::string_view::npos) return text;
    const bool is_charged = text.substr(last).find_first_of("+-") != std::string_view::npos;
    return is_charged ? text.substr(0, last + 1) : text;
}

bool is_hetatm_group(std::string_view group) { return group.size() == 6 && upper_case(group) == "HETATM"; }

bool has_model_numbers(const AtomTable& table) {
    for (std::size_t row = 0; row < table.rows(); ++row)
        if (table.value(AtomColumn::ModelNumber, row) != nullptr) return true;
    return false;
}

int model_number(const CifSource& source, std::size_t row, std::string_view text) {
    const std::optional<int> number = integer(unquoted(text));
    if (!number)
        source.fail(AtomColumn::ModelNumber, row, text, "is not an integer; give every atom the number of its model");
    return *number;
}

}  // namespace

// clang-format off
const std::vector<std::string>& atom_tags() {
    static const std::vector<std::string> tags{
        "Cartn_x", "Cartn_y", "Cartn_z", "?group_PDB", "?id", "?type_symbol", "?label_atom_id", "?auth_atom_id",
        "?label_alt_id", "?label_comp_id", "?auth_comp_id", "?label_asym_id", "?auth_asym_id", "?label_entity_id",
        "?label_seq_id", "?auth_seq_id", "?pdbx_PDB_ins_code", "?occupancy", "?B_iso_or_equiv",
        "?pdbx_formal_charge", "?pdbx_PDB_model_num"};
    return tags;
}
// clang-format on

std::string_view unquoted(std::string_view text) {
    if (text.size() < 2 || (text[0] != '"' && text[0] != '\'' && text[0] != ';')) return text;
    if (text[0] != ';') return text.substr(1, text.size() - 2);
    if (text[text.size() - 2] != '\n') return text;
    return text.substr(1, text.size() - 3);  // there is no '\r' before '\n' (CifFile)
}

void CifSource::fail(AtomColumn::Index column, std::size_t row, std::string_view value,
                     const std::string& message) const {
    const std::string tag = tag_of(column);
    const std::string what = tag + " " + shown(value) + " " + message;
    if (text != nullptr) fail_at(file, locate_cif_value(*text, tag, row), what);
    throw InputError(file + ": row " + std::to_string(row + 1) + ": " + what);
}

std::size_t CifSource::place_of(AtomColumn::Index column, std::size_t row) const {
    return text != nullptr ? locate_cif_value(*text, tag_of(column), row).line : row + 1;
}

std::string CifSource::tag_of(AtomColumn::Index column) {
    const std::string& listed = atom_tags()[column];
    return "_atom_site." + listed.substr(listed[0] == '?' ? 1 : 0);
}

RowModels::RowModels(const CifSource& source, const AtomTable& table) {
    if (!has_model_numbers(table)) {
        models_.push_back({0, table.rows()});
        return;
    }
    std::map<int, std::uint32_t> positions;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        const std::string_view text = *table.at(AtomColumn::ModelNumber, row);
        if (row == 0 || text != *table.at(AtomColumn::ModelNumber, row - 1)) {
            const auto next = static_cast<std::uint32_t>(models_.size());
            const auto [found, is_new] = positions.emplace(model_number(source, row, text), next);
            if (is_new) models_.push_back({row, 0});
            of_row_.push_back(found->second);
        } else {
            of_row_.push_back(of_row_.back());
        }
        ++models_[of_row_.back()].atoms;
    }
    if (models_.size() == 1) of_row_ = {};
}

void OddValues::tell(const CifSource& source, RawModel& model) const {
    const std::string unit = source.unit();
    const std::string symbol = CifSource::tag_of(AtomColumn::Symbol);
    uncertain.tell("standard uncertainties such as that of ", " left out", model.notes, unit);
    charged.tell("charges in " + symbol + " such as that of ", " left out", model.notes, unit);
    for (const auto& [column, odd] : no_numbers)
        odd.tell(CifSource::tag_of(column) + " ", " is not a number; taken as missing", model.warnings, unit);
    if (no_elements.count > 0)
        model.why_guessed = symbol + " " + no_elements.example + " in " + unit + " " +
                            std::to_string(no_elements.first_line) + " is not an element" +
                            (without_symbol ? ", and missing elsewhere" : "");
}

std::string_view AtomRow::text(AtomColumn::Index column) const {
    const std::string_view* const value = table_.value(column, index_);
    if (value == nullptr) return {};
    const std::string_view text = unquoted(*value);
    if (find_unprintable(text) != std::string_view::npos)
        source_.fail(column, index_, text, "contains a byte that is not a printable character; correct it");
    return text;
}

char AtomRow::letter(AtomColumn::Index column, const char* remedy) const {
    const std::string_view value = trimmed(text(column));
    if (value.size() > 1) fail(column, std::string("is longer than one character; ") + remedy);
    return value.empty() ? ' ' : value[0];
}

double AtomRow::coordinate(AtomColumn::Index column, OddValues& odd) const {
    const auto value = number(column, odd);
    if (!value) fail(column, "is not a finite number; correct it or leave the atom out");
    if (std::abs(*value) > kLargestLength)
        fail(column, "is farther from the origin than 1e12 Å; correct it or leave the atom out");
    return *value;
}

double AtomRow::number_or(AtomColumn::Index column, double otherwise, OddValues& odd) const {
    if (!has(column)) return otherwise;
    const auto value = number(column, odd);
    if (!value) note(odd.no_numbers[column], column);
    return value.value_or(otherwise);
}

void AtomRow::set_number(RawResidue& residue) const {
    const AtomColumn::Index column = has(AtomColumn::AuthSeq) ? AtomColumn::AuthSeq : AtomColumn::LabelSeq;
    std::string_view digits = text(column);
    if (digits.empty()) return;
    if (residue.insertion_code == ' ' && is_letter(digits.back())) {
        residue.insertion_code = digits.back();
        digits.remove_suffix(1);
    }
    const auto value = integer(digits);
    const bool is_long = digits.find_first_not_of("+-0123456789") == std::string_view::npos && digits.size() > 9;
    if (!value)
        fail(column, is_long ? "is larger than a residue number may be; correct it" : "is not an integer; correct it");
    residue.number = *value;
}

void AtomRow::set_element(RawAtom& atom, const std::string& residue, OddValues& odd) const {
    const std::string_view symbol = text(AtomColumn::Symbol);
    const std::string_view plain = without_charge(symbol);
    atom.element = element_symbol(plain);
    atom.guessed_element = atom.element.empty();
    if (!atom.guessed_element && plain.size() < symbol.size()) note(odd.charged, AtomColumn::Symbol);
    if (!atom.guessed_element) return;
    if (symbol.empty())
        odd.without_symbol = true;
    else
        note(odd.no_elements, AtomColumn::Symbol);
    atom.element = element_from_name(atom.name, residue);
}

bool AtomRow::is_of_residue_of(const AtomRow& other) const {
    constexpr std::array kColumns{AtomColumn::AuthAsym,  AtomColumn::LabelAsym, AtomColumn::AuthComp,
                                  AtomColumn::LabelComp, AtomColumn::AuthSeq,   AtomColumn::LabelSeq,
                                  AtomColumn::Insertion, AtomColumn::Entity};
    return std::all_of(kColumns.begin(), kColumns.end(), [&](AtomColumn::Index column) {
        const std::string_view* const a = table_.at(column, index_);
        return a == nullptr || *a == *table_.at(column, other.index_);
    });
}

// Nothing if there is no value, or one that is no finite number.
std::optional<double> AtomRow::number(AtomColumn::Index column, OddValues& odd) const {
    const std::string_view* const text = table_.value(column, index_);
    if (text == nullptr) return std::nullopt;
    const std::string_view whole = unquoted(*text);
    const std::string_view plain = without_uncertainty(whole);
    const auto value = finite_number(plain);
    if (value && plain.size() < whole.size()) note(odd.uncertain, column);
    return value;
}

void AtomRow::note(OddLines& odd, AtomColumn::Index column) const {
    odd.add(odd.count > 0 ? 0 : source_.place_of(column, index_), *table_.at(column, index_));
}

void AtomRow::fail(AtomColumn::Index column, const std::string& message) const {
    source_.fail(column, index_, *table_.at(column, index_), message);
}

RawResidue residue_of_row(const AtomRow& row, const EntityIds& polymers) {
    RawResidue residue;
    residue.chain = row.text(AtomColumn::AuthAsym, AtomColumn::LabelAsym);
    residue.label_chain = row.text(AtomColumn::LabelAsym);
    residue.name = upper_case(row.text(AtomColumn::AuthComp, AtomColumn::LabelComp));
    residue.insertion_code = row.letter(AtomColumn::Insertion, "number these residues without it");
    row.set_number(residue);
    residue.in_sequence = polymers.count(row.text(AtomColumn::Entity)) > 0;
    return residue;
}

RawAtom atom_of_row(const AtomRow& row, const std::string& residue, OddValues& odd) {
    RawAtom atom;
    atom.centre = {row.coordinate(AtomColumn::X, odd), row.coordinate(AtomColumn::Y, odd),
                   row.coordinate(AtomColumn::Z, odd)};
    atom.name = upper_case(row.text(AtomColumn::AuthAtom, AtomColumn::LabelAtom));
    row.set_element(atom, residue, odd);
    atom.altloc = row.letter(AtomColumn::AltId, "name the alternative locations A, B ...");
    atom.hetatm = is_hetatm_group(row.text(AtomColumn::Group));
    atom.serial = integer(row.text(AtomColumn::Id)).value_or(0);
    atom.occupancy = row.number_or(AtomColumn::Occupancy, atom.occupancy, odd);
    atom.b_factor = row.number_or(AtomColumn::B, atom.b_factor, odd);
    atom.charge = row.number_or(AtomColumn::Charge, atom.charge, odd);
    return atom;
}

}  // namespace meniscus::reading
