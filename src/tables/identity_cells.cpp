// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tables/identity_cells.h"

#include <algorithm>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

// One-letter fields are empty where there is nothing to tell.
Cell letter(char c) { return c == ' ' || c == '\0' ? std::string() : std::string(1, c); }

}  // namespace

void check_match(const Structure& structure, std::size_t atoms) {
    const bool residues_exist = std::all_of(structure.labels.begin(), structure.labels.end(), [&](const AtomLabel& l) {
        return structure.residues.empty() || l.residue < structure.residues.size();
    });
    if (structure.labels.size() != atoms || !residues_exist)
        throw UsageError("the structure does not describe the atoms that were measured");
}

const Residue& residue_at(const Structure& structure, std::size_t atom) {
    static const Residue kNameless;
    return structure.residues.empty() ? kNameless : structure.residues[structure.labels[atom].residue];
}

std::vector<std::string> identity_columns(RowsPer per) {
    if (per == RowsPer::Atom)
        return {"index", "chain", "resname", "resnum", "icode", "name", "element", "altloc", "serial"};
    if (per == RowsPer::Residue) return {"chain", "resnum", "icode", "resname"};
    return {"chain"};
}

std::vector<Cell> atom_identity(const Structure& structure, std::size_t atom) {
    const AtomLabel& label = structure.labels[atom];
    const Residue& residue = residue_at(structure, atom);
    std::vector<Cell> row;
    add_cells(row, count_cell(atom), residue.chain, residue.name, std::int64_t{residue.number},
              letter(residue.insertion_code), label.name, label.element, letter(label.altloc),
              std::int64_t{label.serial});
    return row;
}

std::vector<Cell> residue_identity(const Residue& residue) {
    std::vector<Cell> row;
    add_cells(row, residue.chain, std::int64_t{residue.number}, letter(residue.insertion_code), residue.name);
    return row;
}

Cell count_cell(std::size_t n) { return static_cast<std::int64_t>(n); }

std::string spaced_label(const Residue& residue) {
    if (residue.name.empty()) return "";
    std::string label = residue.chain.empty() ? "" : residue.chain + ":";
    label += residue.name + " " + std::to_string(residue.number);
    if (residue.insertion_code != ' ') label += residue.insertion_code;
    return label;
}

std::string residue_label(const Residue& residue) {
    if (residue.name.empty()) return "";
    std::string label = residue.chain.empty() ? "" : residue.chain + ":";
    label += residue.name + std::to_string(residue.number);
    if (residue.insertion_code != ' ' && residue.insertion_code != '\0') label += residue.insertion_code;
    return label;
}

}  // namespace meniscus
