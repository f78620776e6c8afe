// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>
#include <utility>

#include "meniscus/errors.h"
#include "meniscus/structure.h"
#include "reading/text.h"
#include "structure/gemmi/gemmi_reader.h"
#include "structure/ligands.h"

namespace meniscus {
namespace {

using reading::RawAtom;
using reading::RawModel;
using reading::RawResidue;

// As much of a model as selections look at.
RawModel to_model(const Structure& structure) {
    RawModel model;
    for (const Residue& residue : structure.residues) {
        RawResidue& raw = model.residues.emplace_back();
        raw.chain = residue.chain;
        raw.name = residue.name;
        raw.number = residue.number;
        raw.insertion_code = residue.insertion_code;
    }
    if (model.residues.empty()) model.residues.emplace_back();
    for (const AtomLabel& label : structure.labels) {
        RawAtom& raw = model.atoms.emplace_back();
        raw.residue = label.residue;
        raw.name = label.name;
        raw.element = label.element;
        raw.altloc = label.altloc;
        raw.occupancy = label.occupancy;
        raw.b_factor = label.b_factor;
    }
    return model;
}

// Everything but atoms and what goes with them.
Structure without_atoms(const Structure& structure) {
    Structure part;
    part.file = structure.file;
    part.name = structure.name;
    part.sha256 = structure.sha256;
    part.radii_set = structure.radii_set;
    part.dropped = structure.dropped;
    part.left_out_ligands = structure.left_out_ligands;
    part.notes = structure.notes;
    part.warnings = structure.warnings;
    return part;
}

}  // namespace

std::vector<bool> select_atoms(const Structure& structure, const std::string& expression, const std::string& option) {
    std::vector<bool> selected = reading::selected_atoms(to_model(structure), expression, 1, option);
    if (std::find(selected.begin(), selected.end(), true) != selected.end()) return selected;
    const std::string restated = restate_selection(structure, expression, option);
    throw UsageError(option + " " + reading::printable(expression, reading::kOfWord) + ": " +
                     (restated.empty() ? "" : "understood as " + reading::printable(restated) + ", ") +
                     "selects none of the kept atoms; write for instance //A/10-50");
}

std::string restate_selection(const Structure& structure, const std::string& expression, const std::string& option) {
    return reading::restated_selection(to_model(structure), expression, option);
}

std::vector<Structure> split_chains(const Structure& structure) {
    std::vector<Structure> chains;
    std::map<std::string, std::size_t> number_of_chain;
    std::map<std::uint32_t, std::uint32_t> residue_in_chain;
    for (std::size_t i = 0; i < structure.atoms.size(); ++i) {
        AtomLabel label = structure.labels[i];
        const std::string chain = structure.residues.empty() ? "" : structure.residues[label.residue].chain;
        const auto [found, is_new_chain] = number_of_chain.try_emplace(chain, chains.size());
        if (is_new_chain) chains.push_back(without_atoms(structure));
        Structure& part = chains[found->second];
        const auto next = static_cast<std::uint32_t>(part.residues.size());
        const auto [residue, is_new] = residue_in_chain.try_emplace(label.residue, next);
        if (is_new && !structure.residues.empty()) part.residues.push_back(structure.residues[label.residue]);
        label.residue = residue->second;
        part.labels.push_back(std::move(label));
        part.atoms.centres.push_back(structure.atoms.centres[i]);
        part.atoms.radii.push_back(structure.atoms.radii[i]);
    }
    for (const auto& [chain, number] : number_of_chain)
        chains[number].ligands = reading::ligands_of_chain(structure.ligands, chain);
    for (Structure& part : chains)
        if (part.atoms.size() < structure.atoms.size())
            part.dropped["chains"] += structure.atoms.size() - part.atoms.size();
    return chains;
}

}  // namespace meniscus
