// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/element.h"

#include <algorithm>
#include <array>

#include "radii/aliases.h"
#include "radii/element_radii.h"
#include "reading/numbers.h"

namespace meniscus::reading {
namespace {

struct Ion {
    std::string_view name;
    std::string_view element;
};

// Single-atom residues whose names are no symbols (CHARMM, AMBER, GROMACS).
constexpr auto kIons = std::to_array<Ion>({
    {"SOD", "NA"}, {"POT", "K"},  {"CLA", "CL"}, {"CAL", "CA"}, {"CES", "CS"}, {"LIT", "LI"}, {"RUB", "RB"},
    {"CIO", "CS"}, {"IB", "I"},   {"CIM", "CL"}, {"CIP", "NA"}, {"MG2", "MG"}, {"ZN2", "ZN"}, {"CA2", "CA"},
    {"FE2", "FE"}, {"FE3", "FE"}, {"3CO", "CO"}, {"3NI", "NI"}, {"CU1", "CU"}, {"MN3", "MN"}, {"IOD", "I"},
});

constexpr std::string_view kCommon = "CNOSPHD";  // elements of the standard residues

std::string without_leading_digits(std::string_view name) {
    const auto* first = std::find_if(name.begin(), name.end(), is_capital);
    return {first, name.end()};
}

std::string one_letter_element(std::string_view letters) { return element_symbol(letters.substr(0, 1)); }

// In the standard residues the first letter is the element, selenium aside.
std::string standard_element(std::string_view letters) {
    if (letters == "SE" || letters == "SED") return "SE";
    const bool common = !letters.empty() && kCommon.find(letters[0]) != std::string_view::npos;
    return common ? std::string(letters.substr(0, 1)) : std::string();
}

// UNK is an unknown amino acid to the PDB, but any small molecule to programs that convert files.
bool is_standard(std::string_view residue) {
    return (is_amino_acid(residue) && residue != "UNK") || is_nucleotide(residue) || is_water(residue);
}

// "CL12", "BR1", "FE1A", "SE", "ZN": two letters that hardly mean anything else. CA, CD, CO, HG, NE, SN ... could.
std::string unmistakable_element(std::string_view letters) {
    constexpr auto kCertain = std::to_array<std::string_view>({"CL", "BR", "FE", "SE", "SI"});
    const std::string pair = element_symbol(letters.substr(0, 2));
    if (pair.size() < 2) return {};
    const bool ambiguous = std::string_view("CNOSPHDBIKFUVWY").find(pair[0]) != std::string_view::npos;
    return !ambiguous || std::find(kCertain.begin(), kCertain.end(), pair) != kCertain.end() ? pair : std::string();
}

std::string letters_of(std::string_view name) {
    std::string letters(name);
    letters.erase(std::remove_if(letters.begin(), letters.end(), [](char c) { return !is_capital(c); }), letters.end());
    return letters;
}

// "NA" in NA+, "CA" in CA2+. Names of ligands have no signs, and digits alone do not make them ions.
bool is_charged_name(std::string_view name, std::string_view residue) {
    return residue.find_first_of("+-") != std::string_view::npos && name == letters_of(residue);
}

// The residue is one atom of its own name: "CA" in CA, "SOD" in SOD, "ZN" in ZN2, "NA" in NA+.
std::string ion_element(std::string_view name, std::string_view residue) {
    const auto* ion = std::find_if(kIons.begin(), kIons.end(), [&](const Ion& i) { return i.name == residue; });
    const bool same = name == residue || is_charged_name(name, residue);
    if (ion != kIons.end() && (same || name == ion->element)) return std::string(ion->element);
    if (!same || residue.size() > 4) return {};
    return element_symbol(letters_of(residue));
}

}  // namespace

std::string upper_case(std::string_view text) {
    std::string upper(text);
    std::transform(upper.begin(), upper.end(), upper.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return upper;
}

std::string element_symbol(std::string_view text) {
    if (text.size() == 1 && kCommon.find(text[0]) != std::string_view::npos) return std::string(text);
    const std::string symbol = upper_case(trimmed(text));
    return !symbol.empty() && symbol.size() <= 2 && is_element(symbol) ? symbol : std::string();
}

std::string element_from_name(std::string_view name, std::string_view residue) {
    const std::string upper = upper_case(trimmed(name));
    if (std::string ion = ion_element(upper, residue); !ion.empty() && !is_standard(residue)) return ion;
    const std::string letters = without_leading_digits(upper);
    if (is_standard(residue)) return standard_element(letters);
    if (std::string pair = unmistakable_element(letters); !pair.empty()) return pair;
    return one_letter_element(letters);
}

std::string element_of_ion(std::string_view name, std::string_view residue) {
    const std::string upper = upper_case(trimmed(name));
    const bool is_ion = residue == "ION" || letters_of(upper) == letters_of(residue);
    return is_ion && !is_standard(residue) ? ion_element(upper, upper) : std::string();
}

std::string element_from_columns(std::string_view name, std::string_view residue) {
    const std::string upper = upper_case(name);
    std::string element = element_from_name(upper, residue);
    const bool two_columns = upper.size() >= 2 && is_capital(upper[0]) && is_capital(upper[1]);
    if (!two_columns) return element;
    // In columns of their own two letters are a symbol: "CA  " of a ligand is calcium.
    const bool full = upper.size() == 4 && upper[3] != ' ';
    const bool is_symbol = element.empty() || (!full && !is_standard(residue) && residue != "UNK");
    const std::string pair = is_symbol ? element_symbol(upper.substr(0, 2)) : std::string();
    return pair.empty() || !ion_element(trimmed(upper), residue).empty() ? element : pair;
}

bool may_be_element(std::string_view name, std::string_view residue, std::string_view symbol) {
    if (symbol.size() != 2) return false;
    if (element_from_columns(name, residue) == symbol) return true;
    return !is_standard(residue) && without_leading_digits(upper_case(trimmed(name))).starts_with(symbol);
}

}  // namespace meniscus::reading
