// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/choose_atoms.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "meniscus/errors.h"
#include "meniscus/list_of_counts.h"
#include "reading/text.h"
#include "structure/additives.h"
#include "structure/altlocs.h"
#include "structure/element.h"
#include "structure/gemmi/gemmi_reader.h"

namespace meniscus::reading {
namespace {

constexpr std::string_view kLabelPrefix = "label:";

bool is_in_chain(const RawResidue& residue, const std::string& chain) {
    if (chain.starts_with(kLabelPrefix)) return residue.label_chain == chain.substr(kLabelPrefix.size());
    return residue.chain == chain;
}

std::string chain_names(const RawModel& model) {
    std::vector<std::string> names;
    for (const RawResidue& residue : model.residues) {
        const std::string name = residue.chain.empty() ? "(blank)" : residue.chain;
        if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
    }
    std::string list;
    for (const std::string& name : names) list.append(list.empty() ? "" : " ").append(name);
    return list;
}

[[noreturn]] void fail_chain(const RawModel& model, const std::string& chain, const std::string& file) {
    throw InputError(file + ": no chain " + chain + "; chains of the file: " + chain_names(model) +
                     (model.left_out.empty() ? "" : " (" + model.left_out + ")"));
}

// Keeps the atoms for which `stays` is true and returns how many went.
template <class Stays>
std::size_t keep_if(std::vector<std::uint32_t>& atoms, Stays stays) {
    const std::size_t before = atoms.size();
    std::erase_if(atoms, [&](std::uint32_t i) { return !stays(i); });
    return before - atoms.size();
}

void apply_chains(const RawModel& model, const std::vector<std::string>& chains, const std::string& file,
                  Chosen& chosen) {
    if (chains.empty()) return;
    for (const std::string& chain : chains) {
        const auto is_here = [&](const RawResidue& residue) { return is_in_chain(residue, chain); };
        if (std::none_of(model.residues.begin(), model.residues.end(), is_here)) {
            fail_chain(model, chain, file);
        }
    }
    chosen.drop("chains", keep_if(chosen.atoms, [&](std::uint32_t i) {
                    const RawResidue& residue = model.residue_of(model.atoms[i]);
                    return std::any_of(chains.begin(), chains.end(),
                                       [&](const std::string& chain) { return is_in_chain(residue, chain); });
                }));
}

void apply_selection(const RawModel& model, const ReadOptions& options, Chosen& chosen) {
    if (options.select.empty()) return;
    const std::string option = options.spelling("select", "");
    const std::string restated = restated_selection(model, options.select, option);
    if (!restated.empty())
        chosen.notes.push_back(options.spelling("select", printable(options.select)) + ": understood as " +
                               printable(restated));
    const std::vector<bool> selected = selected_atoms(model, options.select, options.model, option);
    chosen.drop("unselected", keep_if(chosen.atoms, [&](std::uint32_t i) { return selected[i]; }));
}

// Of atoms whose letter is not the one that was chosen.
std::string substitutes(std::size_t count, const std::string& wanted) {
    const bool one = count == 1;
    const std::string lacking = one ? " lacks " : " lack ";
    const std::string what =
        wanted.empty() ? (one ? "its residue's alternative location" : "the alternative location of their residues")
                       : "alternative location " + wanted;
    return counted(count, "atom") + lacking + what + ": " + (one ? "its own best one" : "their own best ones") +
           " taken";
}

void apply_altlocs(const RawModel& model, const ReadOptions& options, Chosen& chosen) {
    AltlocChoice choice = choose_altlocs(model, chosen.atoms, options.altloc);
    const std::size_t count = chosen.atoms.size() - choice.atoms.size();
    chosen.atoms = std::move(choice.atoms);
    chosen.drop("altlocs", count);
    if (count > 0 && options.altloc.empty()) {
        chosen.notes.push_back(counted(count, "atom") + " of alternative locations left out (choose one with " +
                               options.spelling("altloc", "ID") + ")");
    }
    const auto is_wanted = [&](const RawAtom& a) { return a.altloc == options.altloc[0]; };
    if (!options.altloc.empty() && std::none_of(model.atoms.begin(), model.atoms.end(), is_wanted)) {
        chosen.warnings.push_back("no alternative location " + options.altloc + " here: highest occupancy taken");
    } else if (choice.substitutes > 0) {
        chosen.notes.push_back(substitutes(choice.substitutes, options.altloc));
    }
}

// Leaves out residues of a kind and counts them by name.
std::map<std::string, std::size_t> drop_kind(const RawModel& model, ResidueKind kind, const std::string& reason,
                                             Chosen& chosen) {
    std::set<std::uint32_t> residues;
    const std::size_t count = keep_if(chosen.atoms, [&](std::uint32_t i) {
        const std::uint32_t residue = model.atoms[i].residue;
        if (model.residues[residue].kind != kind) return true;
        residues.insert(residue);
        return false;
    });
    chosen.drop(reason, count);
    std::map<std::string, std::size_t> names;
    for (const std::uint32_t residue : residues) ++names[model.residues[residue].name];
    return names;
}

// What follows the names of residues that are left out; `option` would keep them.
std::string left_out(std::size_t count, const std::string& option) {
    return std::string(" left out (keep ") + (count == 1 ? "it" : "them") + " with " + option + ")";
}

std::size_t sum_of(const std::map<std::string, std::size_t>& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0},
                           [](std::size_t sum, const auto& entry) { return sum + entry.second; });
}

// Most programs that write radii keep the waters of the file that they have read, and nobody sees it.
void tell_kept_waters(const RawModel& model, const ReadOptions& options, Chosen& chosen) {
    std::set<std::uint32_t> waters;
    for (const std::uint32_t i : chosen.atoms)
        if (model.residue_of(model.atoms[i]).kind == ResidueKind::Water) waters.insert(model.atoms[i].residue);
    if (waters.empty()) return;
    chosen.warnings.push_back(counted(waters.size(), "water") + " of the file kept as part of the molecule (leave " +
                              (waters.size() == 1 ? "it" : "them") + " out with " +
                              options.spelling("keep_waters", "false") + ", or keep " +
                              (waters.size() == 1 ? "it" : "them") + " without this warning with " +
                              options.spelling("keep_waters", "true") + ")");
}

void apply_waters(const RawModel& model, const ReadOptions& options, Chosen& chosen) {
    if (model.has_radii && !options.keep_waters) return tell_kept_waters(model, options, chosen);
    if (options.keep_waters.value_or(false)) return;
    const std::size_t count = sum_of(drop_kind(model, ResidueKind::Water, "waters", chosen));
    if (count > 0)
        chosen.notes.push_back(counted(count, "water") + left_out(count, options.spelling("keep_waters", "true")));
}

bool has_polymer(const RawModel& model) {
    return std::any_of(model.residues.begin(), model.residues.end(),
                       [](const RawResidue& residue) { return residue.kind == ResidueKind::Polymer; });
}

// What is drawn as sticks and balls, before it may be left out.
void note_ligands(const RawModel& model, Chosen& chosen) {
    if (!has_polymer(model)) return;
    for (const std::uint32_t i : chosen.atoms) {
        const RawResidue& residue = model.residue_of(model.atoms[i]);
        if (residue.kind == ResidueKind::Ligand && !is_additive(residue.name)) chosen.ligands_drawn.push_back(i);
    }
}

// A small molecule, a lipid bilayer or a crystal of sugar is what its file is about, not something beside a polymer.
HeteroPolicy policy_for(const RawModel& model, const ReadOptions& options) {
    if (options.hetero) return *options.hetero;
    return has_polymer(model) ? HeteroPolicy::None : HeteroPolicy::All;
}

void tell_kept_hetero(const RawModel& model, Chosen& chosen) {
    std::set<std::uint32_t> residues;
    for (const std::uint32_t i : chosen.atoms) residues.insert(model.atoms[i].residue);
    std::map<std::string, std::size_t> names;
    for (const std::uint32_t residue : residues)
        if (model.residues[residue].kind != ResidueKind::Water) ++names[model.residues[residue].name];
    if (!names.empty())
        chosen.notes.push_back("neither protein nor nucleic acid here, so hetero groups are kept: " +
                               list_of_counts(names));
}

void apply_hetero(const RawModel& model, const ReadOptions& options, Chosen& chosen) {
    note_ligands(model, chosen);
    chosen.ligands_stay = true;
    if (model.has_radii && !options.hetero) return;
    const auto apply = [&](ResidueKind kind, const char* remedy) {
        auto names = drop_kind(model, kind, "hetero", chosen);
        if (!names.empty())
            chosen.notes.push_back(list_of_counts(names) + left_out(sum_of(names), options.spelling("hetero", remedy)));
        return names;
    };
    const HeteroPolicy policy = policy_for(model, options);
    if (policy == HeteroPolicy::None) chosen.ligands = apply(ResidueKind::Ligand, "ligands");
    chosen.ligands_stay = policy != HeteroPolicy::None;
    if (policy != HeteroPolicy::All) apply(ResidueKind::Ion, "all");
    if (!options.hetero && policy == HeteroPolicy::All) tell_kept_hetero(model, chosen);
}

// Programs for molecular dynamics write ions into ATOM records, where they pass for parts of the polymer.
void tell_ions_of_polymer(const RawModel& model, const ReadOptions& options, Chosen& chosen) {
    std::vector<std::uint32_t> atoms_of(model.residues.size(), 0);
    for (const std::uint32_t i : chosen.atoms) ++atoms_of[model.atoms[i].residue];
    std::map<std::string, std::size_t> ions;
    for (const std::uint32_t i : chosen.atoms) {
        const RawAtom& atom = model.atoms[i];
        const RawResidue& residue = model.residue_of(atom);
        const bool may_be = residue.kind == ResidueKind::Polymer && !residue.in_sequence && !atom.hetatm;
        if (may_be && atoms_of[atom.residue] == 1 && !element_of_ion(atom.name, residue.name).empty())
            ++ions[residue.name];
    }
    std::string names;
    for (const auto& [name, count] : ions) names += (names.empty() ? "" : ",") + name;
    if (!ions.empty())
        chosen.warnings.push_back("ions in ATOM records kept, as parts of the polymer: " + list_of_counts(ions) +
                                  " (leave them out with " + options.spelling("select", "(!" + names + ")") + ")");
}

}  // namespace

Chosen choose_atoms(const RawModel& model, const ReadOptions& options, const std::string& file) {
    Chosen chosen;
    chosen.atoms.resize(model.atoms.size());
    for (std::size_t i = 0; i < chosen.atoms.size(); ++i) chosen.atoms[i] = static_cast<std::uint32_t>(i);
    apply_chains(model, options.chains, file, chosen);
    apply_selection(model, options, chosen);
    if (!model.has_radii) apply_altlocs(model, options, chosen);
    apply_waters(model, options, chosen);
    apply_hetero(model, options, chosen);
    if (!model.has_radii) tell_ions_of_polymer(model, options, chosen);
    return chosen;
}

}  // namespace meniscus::reading

namespace meniscus {

std::string spell_as_member(std::string_view option, std::string_view value) {
    return value.empty() ? std::string(option) : std::string(option) + " = " + std::string(value);
}

}  // namespace meniscus
