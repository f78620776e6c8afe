// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "values/identity_index.h"

#include <algorithm>
#include <array>

#include "reading/numbers.h"

namespace meniscus {
namespace {

using reading::CsvCell;
using reading::fail_at;
using reading::shown;

constexpr std::array kIdentity{"index", "chain", "resname", "resnum", "icode", "name", "altloc", "serial"};

int integer_in(const CsvCell& cell, const char* column, const std::string& file) {
    if (const auto number = reading::integer(cell.text)) return *number;
    fail_at(file, cell.place, std::string(column) + " " + shown(cell.text) + " is not a whole number");
}

/// One letter, or a blank for an empty cell.
char letter_in(const CsvCell* cell) { return cell == nullptr || cell->text.empty() ? ' ' : cell->text.front(); }

char letter_of(char c) { return c == '\0' ? ' ' : c; }

/// "A" of "A-2", the second copy of chain A in an assembly.
std::string original_chain(const std::string& chain) { return chain.substr(0, chain.find_last_of('-')); }

}  // namespace

IdentityIndex::IdentityIndex(const Structure& structure) : structure_(structure) {
    for (std::uint32_t atom = 0; atom < structure.labels.size(); ++atom) {
        const AtomLabel& label = structure.labels[atom];
        of_serial_.emplace(label.serial, atom);
        if (structure.residues.empty()) continue;
        const Residue& residue = structure.residues[label.residue];
        of_chain_[residue.chain].push_back(atom);
        of_residue_[{residue.chain, residue.number, letter_of(residue.insertion_code)}].push_back(atom);
    }
}

std::optional<std::uint32_t> IdentityIndex::original_of(std::uint32_t atom) const {
    if (structure_.residues.empty()) return std::nullopt;
    const AtomLabel& label = structure_.labels[atom];
    const Residue& residue = structure_.residues[label.residue];
    const std::string original = original_chain(residue.chain);
    if (original == residue.chain) return std::nullopt;
    const auto found = of_residue_.find({original, residue.number, letter_of(residue.insertion_code)});
    if (found == of_residue_.end()) return std::nullopt;
    for (const std::uint32_t other : found->second)
        if (other != atom && structure_.labels[other].name == label.name) return other;
    return std::nullopt;
}

bool IdentityIndex::is_identity(const std::string& column) {
    return std::find(kIdentity.begin(), kIdentity.end(), column) != kIdentity.end();
}

std::string IdentityIndex::identity_columns() {
    std::string list;
    for (const char* column : kIdentity) list.append(list.empty() ? "" : ", ").append(column);
    return list;
}

std::string IdentityIndex::missing_columns(const IdentityColumns& columns) const {
    const auto has = [&](const char* column) { return columns.contains(column); };
    if (has("index") || has("serial")) return "";
    if (has("resnum") && !has("chain") && of_chain_.size() > 1)
        return "no column 'chain', but the structure has several chains; add it";
    if (has("name") && !has("resnum")) return "a column 'name' but no 'resnum'; add it";
    if (has("resnum") || has("chain")) return "";
    return "no column says which atoms or residues the rows belong to; add a column resnum, chain, index or serial, in "
           "small letters";
}

std::vector<std::uint32_t> IdentityIndex::atoms_of(const CellOf& cell, const std::string& file) const {
    std::vector<std::uint32_t> atoms;
    if (cell("index") != nullptr)
        atoms = by_index(cell, file);
    else if (cell("resnum") != nullptr)
        atoms = by_residue(cell, file);
    else
        atoms = cell("serial") != nullptr ? by_serial(cell, file) : by_chain(cell);
    for (const std::uint32_t atom : atoms) check_agreement(atom, cell, file);
    return atoms;
}

std::vector<std::uint32_t> IdentityIndex::by_index(const CellOf& cell, const std::string& file) const {
    const int index = integer_in(*cell("index"), "index", file);
    if (index < 0 || static_cast<std::size_t>(index) >= structure_.labels.size()) return {};
    return {static_cast<std::uint32_t>(index)};
}

std::vector<std::uint32_t> IdentityIndex::by_serial(const CellOf& cell, const std::string& file) const {
    const auto [begin, end] = of_serial_.equal_range(integer_in(*cell("serial"), "serial", file));
    std::vector<std::uint32_t> atoms;
    std::transform(begin, end, std::back_inserter(atoms), [](const auto& entry) { return entry.second; });
    return atoms;
}

std::vector<std::uint32_t> IdentityIndex::by_residue(const CellOf& cell, const std::string& file) const {
    const CsvCell* chain = cell("chain");
    if (of_chain_.empty()) return {};
    const std::string& name = chain != nullptr ? chain->text : of_chain_.begin()->first;
    const auto found = of_residue_.find({name, integer_in(*cell("resnum"), "resnum", file), letter_in(cell("icode"))});
    if (found == of_residue_.end()) return {};
    std::vector<std::uint32_t> atoms;
    std::copy_if(found->second.begin(), found->second.end(), std::back_inserter(atoms),
                 [&](std::uint32_t atom) { return is_named(atom, cell); });
    return atoms;
}

std::vector<std::uint32_t> IdentityIndex::by_chain(const CellOf& cell) const {
    const auto found = of_chain_.find(cell("chain")->text);
    return found == of_chain_.end() ? std::vector<std::uint32_t>{} : found->second;
}

/// Rows of residues are about all their atoms, rows of atoms about one, or one in each alternative.
bool IdentityIndex::is_named(std::uint32_t atom, const CellOf& cell) const {
    const AtomLabel& label = structure_.labels[atom];
    const CsvCell* name = cell("name");
    const CsvCell* altloc = cell("altloc");
    return (name == nullptr || name->text == label.name) &&
           (altloc == nullptr || letter_in(altloc) == letter_of(label.altloc));
}

void IdentityIndex::check_agreement(std::uint32_t atom, const CellOf& cell, const std::string& file) const {
    const AtomLabel& label = structure_.labels[atom];
    static const Residue kNameless;
    const Residue& residue = structure_.residues.empty() ? kNameless : structure_.residues[label.residue];
    const auto check = [&](const char* column, const std::string& known) {
        const CsvCell* given = cell(column);
        if (given == nullptr || given->text == known) return;
        fail_at(file, given->place,
                std::string(column) + " is " + shown(given->text) + " here, but " + shown(known) +
                    " in the structure; does the table belong to another structure?");
    };
    check("resname", residue.name);
    check("name", label.name);
    if (cell("index") == nullptr) return;
    check("chain", residue.chain);
    check("resnum", std::to_string(residue.number));
}

}  // namespace meniscus
