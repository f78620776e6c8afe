// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <set>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "radii/aliases.h"
#include "tables/identity_cells.h"
#include "tables/tien_maxima.h"

namespace meniscus {
namespace {

std::vector<GroupMeasure> sum_over_groups(const Measures& measures, std::span<const std::uint32_t> group_of_atom,
                                          std::size_t groups) {
    std::vector<GroupMeasure> sums(groups);
    for (std::size_t i = 0; i < measures.atoms.size(); ++i) {
        const AtomMeasure& atom = measures.atoms[i];
        GroupMeasure& sum = sums[group_of_atom[i]];
        sum.max_depth = sum.atoms == 0 ? atom.depth : std::max(sum.max_depth, atom.depth);
        ++sum.atoms;
        sum.sas_area += atom.sas_area;
        sum.contact_area += atom.contact_area;
        sum.toroidal_area += atom.toroidal_area;
        sum.reentrant_area += atom.reentrant_area;
        sum.mean_depth += atom.depth;
    }
    for (GroupMeasure& sum : sums)
        if (sum.atoms > 0) sum.mean_depth /= static_cast<double>(sum.atoms);
    return sums;
}

}  // namespace

std::vector<GroupMeasure> residue_measures(const Structure& structure, const Measures& measures) {
    check_match(structure, measures.atoms.size());
    std::vector<std::uint32_t> residue(structure.labels.size());
    std::transform(structure.labels.begin(), structure.labels.end(), residue.begin(),
                   [&](const AtomLabel& l) { return structure.residues.empty() ? 0 : l.residue; });
    return sum_over_groups(measures, residue, std::max<std::size_t>(structure.residues.size(), 1));
}

Chains chains_of(const Structure& structure) {
    Chains chains;
    std::map<std::string, std::uint32_t> places;
    chains.of_atom.reserve(structure.labels.size());
    const Residue* residue = nullptr;  // of the atom before
    std::uint32_t chain = 0;
    for (std::size_t i = 0; i < structure.labels.size(); ++i) {
        if (residue != &residue_at(structure, i)) {
            residue = &residue_at(structure, i);
            const auto [place, is_new] =
                places.emplace(residue->chain, static_cast<std::uint32_t>(chains.names.size()));
            if (is_new) chains.names.push_back(residue->chain);
            chain = place->second;
        }
        chains.of_atom.push_back(chain);
    }
    return chains;
}

std::vector<GroupMeasure> chain_measures(const Structure& structure, const Measures& measures) {
    check_match(structure, measures.atoms.size());
    const Chains chains = chains_of(structure);
    return sum_over_groups(measures, chains.of_atom, chains.names.size());
}

std::optional<double> relative_accessibility(std::string_view residue_name, double sas_area) {
    const std::optional<double> maximum = tien_maximum(canonical_names(residue_name, "CA").residue);
    if (!maximum) return std::nullopt;
    return sas_area / *maximum;
}

std::vector<double> atom_values(const Structure& structure, const Measures& measures, AtomValue value) {
    constexpr double kNoValue = -1.0;
    const std::vector<GroupMeasure> residues = residue_measures(structure, measures);
    std::vector<double> values(measures.atoms.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
        const AtomMeasure& atom = measures.atoms[i];
        if (value == AtomValue::Sas) values[i] = atom.sas_area;
        if (value == AtomValue::Ses) values[i] = atom.ses_area();
        if (value == AtomValue::Depth) values[i] = atom.depth;
        if (value == AtomValue::Rsa) {
            const double area = structure.residues.empty() ? 0.0 : residues[structure.labels[i].residue].sas_area;
            values[i] = relative_accessibility(residue_at(structure, i).name, area).value_or(kNoValue);
        }
    }
    return values;
}

std::vector<std::uint32_t> lining_residues(const Structure& structure, const SurfaceComponent& component) {
    std::set<std::uint32_t> residues;
    if (!structure.residues.empty())
        for (const std::uint32_t atom : component.atoms) residues.insert(structure.labels.at(atom).residue);
    return {residues.begin(), residues.end()};
}

}  // namespace meniscus
