// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/make_structure.h"

#include <algorithm>
#include <utility>

#include "meniscus/errors.h"
#include "reading/text.h"
#include "structure/assign_radii.h"
#include "structure/build_structure.h"
#include "structure/choose_atoms.h"
#include "structure/coincident.h"
#include "structure/guessed_elements.h"
#include "structure/hydrogens.h"
#include "structure/join_residues.h"
#include "structure/ligands.h"
#include "structure/residue_kinds.h"

namespace meniscus::reading {
namespace {

[[noreturn]] void fail_empty(const std::string& path, const RawModel& model, const Chosen& chosen,
                             OptionSpelling spelling) {
    if (model.atoms.empty()) {
        throw InputError(path + ": no atoms in this file; check that it is the right one" +
                         (model.warnings.empty() ? "" : " (" + model.warnings.front() + ")"));
    }
    std::vector<std::string> lines = model.warnings;
    append(lines, chosen.notes);
    append(lines, chosen.warnings);
    std::string reasons;
    for (const std::string& line : lines) reasons += (reasons.empty() ? "" : "; ") + line;
    throw InputError(path + ": no atoms left" +
                     (reasons.empty() ? "; " + spelling("chains", "") + " or " + spelling("select", "") + " keep none"
                                      : ": " + reasons));
}

std::string why_guessed(const InputFile& file, const RawModel& model) {
    if (!model.why_guessed.empty()) return model.why_guessed;
    if (file.format == Format::Pdbqt) return "the types of atoms in columns 78-79 are not AutoDock's";
    const bool is_cif = file.format == Format::Cif || file.format == Format::Bcif;
    return is_cif ? "_atom_site.type_symbol is not given" : "columns 77-78 are blank";
}

// Ligands show hydrogens where the surface has some.
void match_hydrogens(const RawModel& model, Chosen& chosen) {
    const auto is_one = [&](std::uint32_t i) { return is_hydrogen(model.atoms[i]); };
    if (std::none_of(chosen.atoms.begin(), chosen.atoms.end(), is_one)) std::erase_if(chosen.ligands_drawn, is_one);
}

}  // namespace

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

void check_options(const ReadOptions& options) {
    if (options.model < 1)
        throw UsageError(options.spelling("model", std::to_string(options.model)) + ": models are counted from 1");
    if (options.join_models && !options.assembly.empty())
        throw UsageError(options.spelling("model", "join") + ": the models of a file are not to be copied by " +
                         options.spelling("assembly", "") + "; give one of the two");
    if (options.altloc.size() > 1)
        throw UsageError(options.spelling("altloc", options.altloc) + ": must be one character");
}

void complete_model(RawModel& model) {
    join_residues(model);
    correct_lone_ions(model);
    classify_residues(model);
}

MadeStructure make_structure(const InputFile& file, const RawModel& model, const ReadOptions& options) {
    Chosen chosen = choose_atoms(model, options, file.path);
    const AssignedRadii radii = assign_radii(model, options, file.path, chosen);
    if (chosen.atoms.empty()) fail_empty(file.path, model, chosen, options.spelling);
    match_hydrogens(model, chosen);
    tell_guessed_elements(model, why_guessed(file, model), chosen);
    Structure structure;
    structure.file = file.path;
    structure.name = file.name;
    structure.sha256 = file.sha256;
    structure.radii_set = radii.set;
    structure.dropped = chosen.dropped;
    structure.left_out_ligands = chosen.ligands;
    structure.notes = model.notes;
    append(structure.notes, chosen.notes);
    structure.warnings = model.warnings;
    append(structure.warnings, chosen.warnings);
    build_structure(model, chosen, radii, options.assembly, structure);
    structure.ligands.bonds = find_bonds(structure.ligands);
    structure.ligands.in_surface = chosen.ligands_stay && !structure.ligands.centres.empty();
    if (structure.atoms.empty()) throw InputError(file.path + ": assembly " + options.assembly + " has no kept atoms");
    if (const std::size_t count = count_coincident(structure.atoms.centres); count > 0) {
        structure.warnings.push_back(counted(count, "atom") + " at exactly the position of another atom");
    }
    return {std::move(structure), std::move(chosen.atoms)};
}

}  // namespace meniscus::reading
