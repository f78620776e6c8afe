// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <map>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "tables/identity_cells.h"

namespace meniscus {
namespace {

std::string joined(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list.append(list.empty() ? "" : ",").append(name);
    return list;
}

// Rows of one side of one interface; the first cells are the same for all.
class Side {
public:
    Side(const Structure& structure, const AtomGroup& group, std::span<const InterfaceAtom> atoms, RowsPer per,
         std::vector<Cell> first)
        : structure_(structure), group_(group), atoms_(atoms), per_(per), first_(std::move(first)) {}

    void add_to(Table& table) const {
        if (per_ == RowsPer::Atom) {
            for (std::size_t i = 0; i < group_.size(); ++i)
                add_row(table, atom_identity(structure_, group_[i]), atoms_[i]);
            return;
        }
        const Chains chains = chains_of(structure_);
        std::map<std::uint32_t, InterfaceAtom> sums;
        for (std::size_t i = 0; i < group_.size(); ++i)
            sums[per_ == RowsPer::Chain ? chains.of_atom[group_[i]] : structure_.labels[group_[i]].residue] +=
                atoms_[i];
        for (const auto& [place, sum] : sums)
            add_row(table, per_ == RowsPer::Chain ? std::vector<Cell>{chains.names[place]} : residue_cells(place), sum);
    }

private:
    std::vector<Cell> residue_cells(std::uint32_t place) const {
        return residue_identity(structure_.residues.empty() ? Residue() : structure_.residues[place]);
    }

    void add_row(Table& table, const std::vector<Cell>& identity, const InterfaceAtom& areas) const {
        std::vector<Cell> row = first_;
        row.insert(row.end(), identity.begin(), identity.end());
        for (const double area : {areas.sas_alone, areas.sas_complex, areas.buried_sas(), areas.ses_alone,
                                  areas.ses_complex, areas.buried_ses()})
            row.emplace_back(area);
        table.rows.push_back(std::move(row));
    }

    const Structure& structure_;
    const AtomGroup& group_;
    std::span<const InterfaceAtom> atoms_;
    RowsPer per_;
    std::vector<Cell> first_;
};

}  // namespace

Table interface_table(const Structure& structure, std::span<const ChainInterface> interfaces, RowsPer per) {
    if (per == RowsPer::Cavity) throw UsageError("an interface has no table per cavity");
    Table table;
    table.columns = {"interface", "side"};
    for (const std::string& column : identity_columns(per)) table.columns.push_back(column);
    for (const char* column : {"sas_alone", "sas_complex", "buried_sas", "ses_alone", "ses_complex", "buried_ses"})
        table.columns.emplace_back(column);
    for (const ChainInterface& i : interfaces) {
        const std::string name = joined(i.chains.a) + ":" + joined(i.chains.b);
        Side(structure, i.group_a, i.areas.atoms_a, per, {name, std::string("a")}).add_to(table);
        Side(structure, i.group_b, i.areas.atoms_b, per, {name, std::string("b")}).add_to(table);
    }
    return table;
}

}  // namespace meniscus
