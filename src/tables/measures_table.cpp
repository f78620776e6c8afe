// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/tables.h"
#include "tables/identity_cells.h"

namespace meniscus {
namespace {

std::vector<std::string> with_columns(RowsPer per, const std::vector<std::string>& others) {
    std::vector<std::string> columns = identity_columns(per);
    columns.insert(columns.end(), others.begin(), others.end());
    return columns;
}

template <class Shares>
void add_areas(std::vector<Cell>& row, const Shares& shares) {
    add_cells(row, shares.sas_area, shares.ses_area(), shares.contact_area, shares.toroidal_area,
              shares.reentrant_area);
}

Cell depth_cell(const Measures& measures, double depth) {
    return measures.options.depth ? Cell(depth) : Cell(std::monostate());
}

Table atom_table(const Structure& structure, const Measures& measures) {
    Table table;
    table.columns = with_columns(
        RowsPer::Atom, {"sas_area", "ses_area", "contact_area", "toroidal_area", "reentrant_area", "depth", "buried"});
    for (std::size_t i = 0; i < measures.atoms.size(); ++i) {
        const AtomMeasure& atom = measures.atoms[i];
        std::vector<Cell> row = atom_identity(structure, i);
        add_areas(row, atom);
        add_cells(row, depth_cell(measures, atom.depth), atom.sas_area < kBuriedArea);
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table residue_table(const Structure& structure, const Measures& measures) {
    Table table;
    table.columns = with_columns(RowsPer::Residue, {"atoms", "sas_area", "ses_area", "contact_area", "toroidal_area",
                                                    "reentrant_area", "rsa", "mean_depth", "max_depth", "buried"});
    const std::vector<GroupMeasure> sums = residue_measures(structure, measures);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        const Residue residue = structure.residues.empty() ? Residue() : structure.residues[i];
        const std::optional<double> rsa = relative_accessibility(residue.name, sums[i].sas_area);
        std::vector<Cell> row = residue_identity(residue);
        row.push_back(count_cell(sums[i].atoms));
        add_areas(row, sums[i]);
        add_cells(row, rsa ? Cell(*rsa) : Cell(), depth_cell(measures, sums[i].mean_depth),
                  depth_cell(measures, sums[i].max_depth), sums[i].buried());
        table.rows.push_back(std::move(row));
    }
    return table;
}

Table chain_table(const Structure& structure, const Measures& measures) {
    Table table;
    table.columns = with_columns(RowsPer::Chain, {"atoms", "sas_area", "ses_area", "contact_area", "toroidal_area",
                                                  "reentrant_area", "mean_depth", "max_depth", "buried"});
    const Chains chains = chains_of(structure);
    const std::vector<GroupMeasure> sums = chain_measures(structure, measures);
    for (std::size_t i = 0; i < sums.size(); ++i) {
        std::vector<Cell> row;
        add_cells(row, chains.names[i], count_cell(sums[i].atoms));
        add_areas(row, sums[i]);
        add_cells(row, depth_cell(measures, sums[i].mean_depth), depth_cell(measures, sums[i].max_depth),
                  sums[i].buried());
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::string names_of(const Structure& structure, const std::vector<std::uint32_t>& residues) {
    std::string names;
    for (const std::uint32_t r : residues)
        names.append(names.empty() ? "" : " ").append(residue_label(structure.residues[r]));
    return names;
}

std::vector<Cell> cavity_row(const Structure& structure, const SurfaceComponent& c, std::size_t place) {
    const std::vector<std::uint32_t> residues = lining_residues(structure, c);
    std::vector<Cell> row;
    add_cells(row, count_cell(place), c.ses_area, c.contact_area, c.toroidal_area, c.reentrant_area, c.ses_volume,
              c.sas_area, c.sas_volume, count_cell(c.sas_components), c.centre.x, c.centre.y, c.centre.z,
              c.inscribed_radius, c.inscribed_centre.x, c.inscribed_centre.y, c.inscribed_centre.z,
              c.inside_of == kNone ? Cell() : Cell(std::int64_t{c.inside_of}), count_cell(c.atoms.size()),
              count_cell(residues.size()), names_of(structure, residues));
    return row;
}

Table cavity_table(const Structure& structure, const Measures& measures) {
    Table table;
    table.columns = {"component",        "ses_area",    "contact_area",  "toroidal_area",
                     "reentrant_area",   "ses_volume",  "sas_area",      "sas_volume",
                     "sas_components",   "centre_x",    "centre_y",      "centre_z",
                     "inscribed_radius", "inscribed_x", "inscribed_y",   "inscribed_z",
                     "inside_of",        "atoms",       "residue_count", "residues"};
    for (std::size_t i = 0; i < measures.components.size(); ++i)
        if (measures.components[i].kind == ComponentKind::Cavity)
            table.rows.push_back(cavity_row(structure, measures.components[i], i));
    return table;
}

}  // namespace

Table measures_table(const Structure& structure, const Measures& measures, RowsPer per) {
    check_match(structure, measures.atoms.size());
    switch (per) {
        case RowsPer::Atom:
            return atom_table(structure, measures);
        case RowsPer::Residue:
            return residue_table(structure, measures);
        case RowsPer::Chain:
            return chain_table(structure, measures);
        case RowsPer::Cavity:
            return cavity_table(structure, measures);
    }
    return {};
}

}  // namespace meniscus
