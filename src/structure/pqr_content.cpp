// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pqr_content.h"

#include <algorithm>
#include <string>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/element.h"
#include "structure/pdb_columns.h"
#include "structure/pdb_records.h"
#include "structure/pqr_layout.h"
#include "structure/pqr_words.h"

namespace meniscus::reading {
namespace {

constexpr double kLargestRadius = 4.0;  // Å; no atom of a force field is larger

// gmx editconf -mead writes charges and radii into the columns of PDB.
bool tells_radii(std::string_view line) {
    return line.starts_with("REMARK") && line.find("B-factors in this file hold atomic radii") != line.npos;
}

std::string_view occupancy_columns(std::string_view line) { return line.substr(54, 6); }
std::string_view b_factor_columns(std::string_view line) { return line.substr(60, 6); }

// Numbers between blanks hardly ever stand so by chance.
bool has_b_factor_in_columns(std::string_view line) {
    constexpr std::size_t kBFactorEnd = 66;
    if (line.size() < kBFactorEnd || !has_usual_columns(line) || line[57] != '.' || line[63] != '.') return false;
    return finite_number(occupancy_columns(line)) && finite_number(b_factor_columns(line)) &&
           (line.size() == kBFactorEnd || is_blank(line[kBFactorEnd]));
}

// One number each for occupancy and B factor, of whatever decimals, and the symbol of an element.
bool has_pdb_fields(std::string_view line) {
    if (line.size() < 78 || !has_usual_columns(line) || element_symbol(line.substr(76, 2)).empty()) return false;
    return finite_number(occupancy_columns(line)) && finite_number(b_factor_columns(line));
}

bool is_like_pdb(std::string_view line) {
    if (!has_b_factor_in_columns(line)) return false;
    const double occupancy = *finite_number(occupancy_columns(line));
    const bool has_element = line.size() > 77 && !element_symbol(line.substr(76, 2)).empty();
    return has_element || (occupancy >= 0.0 && occupancy <= 1.0);
}

bool is_plausible(double largest_radius) { return largest_radius > 0.0 && largest_radius <= kLargestRadius; }

// "1.00" and "0.00" may be occupancies, and a number without a point may be anything.
bool is_surely_charge(std::string_view word) {
    constexpr std::size_t kOfOccupancy = 4;  // characters
    if (word.find('.') == std::string_view::npos) return false;
    const double value = finite_number(word).value_or(0.0);
    return word.size() > kOfOccupancy || (value != 0.0 && value != 1.0);
}

// What the atoms of a text have where PQR has charges and radii.
struct ChargesAndRadii {
    bool has_charges = false;
    double largest_radius = 0.0;

    // False if the words of an atom's line are not those of PQR.
    bool take(std::string_view text) {
        const std::string no_file;
        const WordLine line(no_file, 0, pqr_words(text));
        const auto layout = fitting_layout(line);
        const bool has_more_than_element = layout && line.size() > layout->radius() + 2;
        if (!layout || has_more_than_element) return false;
        has_charges = has_charges || is_surely_charge(line[layout->charge()]);
        largest_radius = std::max(largest_radius, finite_number(line[layout->radius()]).value_or(0.0));
        return true;
    }
};

}  // namespace

bool is_surely_pqr(std::string_view text) {
    ChargesAndRadii seen;
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (tells_radii(line)) return true;
        if (kind_of_pqr_line(line) != PqrLine::Atom) continue;
        if (has_b_factor_in_columns(line) || has_pdb_fields(line) || !seen.take(line)) return false;
    }
    return seen.has_charges && is_plausible(seen.largest_radius);
}

bool is_surely_pdb(std::string_view text) {
    std::size_t atoms = 0;
    std::size_t like_pdb = 0;
    double largest_radius = 0.0;
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (tells_radii(line)) return false;
        atoms += static_cast<std::size_t>(is_atom_record(line));
        if (!is_atom_record(line) || !is_like_pdb(line)) continue;
        ++like_pdb;
        largest_radius = std::max(largest_radius, *finite_number(b_factor_columns(line)));
    }
    return 2 * like_pdb > atoms && !is_plausible(largest_radius);
}

}  // namespace meniscus::reading
