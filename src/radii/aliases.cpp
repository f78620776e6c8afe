// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "radii/aliases.h"

#include <algorithm>
#include <array>

namespace meniscus {
namespace {

struct Alias {
    std::string_view name;
    std::string_view canonical;
};

// Protonation states and force-field names (AMBER, CHARMM, GROMACS).
constexpr auto kResidueAliases = std::to_array<Alias>({
    {"HID", "HIS"},  {"HIE", "HIS"},  {"HIP", "HIS"},  {"HSD", "HIS"}, {"HSE", "HIS"},  {"HSP", "HIS"},
    {"HISD", "HIS"}, {"HISE", "HIS"}, {"HISH", "HIS"}, {"CYX", "CYS"}, {"CYM", "CYS"},  {"CYS2", "CYS"},
    {"CYSH", "CYS"}, {"ASH", "ASP"},  {"ASPP", "ASP"}, {"GLH", "GLU"}, {"GLUP", "GLU"}, {"LYN", "LYS"},
    {"LYSH", "LYS"}, {"TYM", "TYR"},  {"ADE", "A"},    {"CYT", "C"},   {"GUA", "G"},    {"URA", "U"},
    {"THY", "DT"},   {"RA", "A"},     {"RC", "C"},     {"RG", "G"},    {"RU", "U"},     {"A3", "A"},
    {"A5", "A"},     {"C3", "C"},     {"C5", "C"},     {"G3", "G"},    {"G5", "G"},     {"U3", "U"},
    {"U5", "U"},     {"DA3", "DA"},   {"DA5", "DA"},   {"DC3", "DC"},  {"DC5", "DC"},   {"DG3", "DG"},
    {"DG5", "DG"},   {"DT3", "DT"},   {"DT5", "DT"},   {"+A", "A"},    {"+C", "C"},     {"+G", "G"},
    {"+U", "U"},     {"+I", "I"},
});

constexpr auto kAtomAliases = std::to_array<Alias>({
    {"OT1", "O"},
    {"OT2", "OXT"},
    {"OC1", "O"},
    {"OC2", "OXT"},
    {"O1P", "OP1"},
    {"O2P", "OP2"},
    {"O3P", "OP3"},
    {"OT", "OXT"},
});

constexpr auto kAminoAcids = std::to_array<std::string_view>({
    "ALA", "ARG", "ASN", "ASP", "ASX", "CYS", "GLN", "GLU", "GLX", "GLY", "HIS", "ILE", "LEU", "LYS", "MET",
    "MSE", "PHE", "PRO", "PYL", "SEC", "SER", "THR", "TRP", "TYR", "UNK", "VAL", "ACE", "NME", "NMA", "NH2",
});

constexpr auto kNucleotides =
    std::to_array<std::string_view>({"A", "C", "G", "I", "T", "U", "N", "DA", "DC", "DG", "DI", "DN", "DT", "DU"});

constexpr auto kWaters = std::to_array<std::string_view>({
    "HOH", "WAT", "DOD",  "H2O",   "D2O",   "TIP",   "TIP2", "TIP3", "TIP4", "TIP5", "TP3",
    "TP4", "TP5", "T3P",  "T4P",   "T5P",   "SOL",   "SPC",  "SPCE", "OH2",  "HHO",  "OHH",
    "OPC", "WTR", "HOH1", "TIP3P", "TIP4P", "TIP5P", "T3H",  "SWM4", "SWM6",
});

template <class Table>
bool contains(const Table& table, std::string_view name) {
    return std::find(table.begin(), table.end(), name) != table.end();
}

template <class Table>
std::string_view canonical(const Table& table, std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const Alias& a) { return a.name == name; });
    return found == table.end() ? name : found->canonical;
}

}  // namespace

CanonicalNames canonical_names(std::string_view residue, std::string_view atom) {
    CanonicalNames names{std::string(canonical(kResidueAliases, residue)), std::string(canonical(kAtomAliases, atom))};
    std::replace(names.atom.begin(), names.atom.end(), '*', '\'');
    // Before 2007 hydrogens of the wwPDB had their number in front: 1HH2 is HH21 today.
    if (names.atom.size() > 1 && names.atom[0] >= '1' && names.atom[0] <= '9' && names.atom[1] == 'H') {
        std::rotate(names.atom.begin(), names.atom.begin() + 1, names.atom.end());
    }
    if (names.residue == "ILE" && names.atom == "CD") names.atom = "CD1";
    if ((names.residue == "T" || names.residue == "DT") && names.atom == "C5M") names.atom = "C7";
    return names;
}

bool is_amino_acid(std::string_view residue) { return contains(kAminoAcids, canonical(kResidueAliases, residue)); }

bool is_nucleotide(std::string_view residue) { return contains(kNucleotides, canonical(kResidueAliases, residue)); }

bool is_water(std::string_view residue) { return contains(kWaters, residue); }

}  // namespace meniscus
