// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/gemmi/gemmi_reader.h"

// Debian's gemmi leaves out the printing library that it bundles; nothing here prints through it.
#define USE_STD_SNPRINTF
// gemmi is not written for our warnings.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <gemmi/mmcif.hpp>
#include <gemmi/pdb.hpp>
#include <gemmi/select.hpp>
#pragma GCC diagnostic pop

#include <algorithm>
#include <functional>
#include <string_view>
#include <utility>

#include "meniscus/errors.h"
#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/gemmi/gemmi_shared.h"
#include "structure/residue_list.h"
#include "structure/selection_words.h"

namespace meniscus::reading {
namespace {

RawOperator to_operator(const gemmi::Transform& transform) {
    RawOperator result;
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) result.rows[4 * row + column] = transform.mat[row][column];
        result.rows[4 * row + 3] = transform.vec.at(row);
    }
    return result;
}

std::vector<RawAssembly> to_assemblies(const std::vector<gemmi::Assembly>& assemblies) {
    std::vector<RawAssembly> result;
    for (const gemmi::Assembly& assembly : assemblies) {
        RawAssembly& raw = result.emplace_back();
        raw.name = assembly.name;
        for (const gemmi::Assembly::Gen& generator : assembly.generators) {
            RawGenerator& copy = raw.generators.emplace_back();
            copy.label_names = generator.chains.empty();
            copy.chains = copy.label_names ? generator.subchains : generator.chains;
            for (const auto& op : generator.operators) copy.operators.push_back(to_operator(op.transform));
        }
    }
    return result;
}

// ---- PDB

bool is_listed(const gemmi::Structure& structure, const gemmi::Chain& chain, const gemmi::Residue& residue) {
    const gemmi::Entity* entity = structure.get_entity(chain.name);
    return entity != nullptr && residue.entity_type == gemmi::EntityType::Polymer &&
           std::find(entity->full_sequence.begin(), entity->full_sequence.end(), residue.name) !=
               entity->full_sequence.end();
}

// Where gemmi's Structure has a run of atoms: the parser groups them its own way.
struct ParsedRun {
    const gemmi::Chain* chain = nullptr;
    const gemmi::Residue* residue = nullptr;
};

std::vector<ParsedRun> in_file_order(const gemmi::Structure& structure, std::size_t count, const std::string& file) {
    std::vector<ParsedRun> runs(count);
    std::size_t found = 0;
    for (const gemmi::Chain& chain : structure.models.at(0).chains) {
        for (const gemmi::Residue& residue : chain.residues) {
            for (const gemmi::Atom& atom : residue.atoms) {
                runs.at(static_cast<std::size_t>(atom.serial) - 1) = {&chain, &residue};
                ++found;
            }
        }
    }
    if (found != count) throw InputError(file + ": atoms were lost in parsing; please report this file");
    return runs;
}

RawResidue to_residue(const gemmi::Structure& structure, const ParsedRun& parsed, const PdbRun& run) {
    RawResidue residue;
    residue.chain = parsed.chain->name;
    residue.segment = run.segment;
    residue.name = run.residue;
    residue.number = run.number.number;
    residue.insertion_code = run.number.insertion_code;
    residue.in_sequence = is_listed(structure, *parsed.chain, *parsed.residue);
    return residue;
}

RawModel to_model(const gemmi::Structure& structure, CleanPdb clean, const std::string& file) {
    RawModel model;
    ResidueList residues(model.residues);
    const std::vector<ParsedRun> parsed = in_file_order(structure, clean.runs.size(), file);
    std::vector<std::uint32_t> residue_of_run(parsed.size());
    for (std::size_t run = 0; run < parsed.size(); ++run)
        residue_of_run[run] = residues.index_of(to_residue(structure, parsed[run], clean.runs[run]));
    model.atoms = std::move(clean.atoms);
    for (RawAtom& atom : model.atoms) atom.residue = residue_of_run[atom.residue];
    model.assemblies = to_assemblies(structure.assemblies);
    model.warnings = std::move(clean.warnings);
    return model;
}

// ---- selection

gemmi::EntityType to_entity_type(ResidueKind kind) {
    switch (kind) {
        case ResidueKind::Polymer:
            return gemmi::EntityType::Polymer;
        case ResidueKind::Water:
            return gemmi::EntityType::Water;
        default:
            return gemmi::EntityType::NonPolymer;
    }
}

bool matches_residue(const gemmi::Selection& selection, const RawResidue& residue) {
    gemmi::Residue copy;
    copy.name = residue.name;
    copy.seqid.num = residue.number;
    copy.seqid.icode = residue.insertion_code;
    copy.entity_type = to_entity_type(residue.kind);
    return selection.matches(gemmi::Chain(residue.chain)) && selection.matches(copy);
}

bool matches_atom(const gemmi::Selection& selection, const RawAtom& atom) {
    gemmi::Atom copy;
    copy.name = atom.name;
    copy.element = gemmi::Element(atom.element);
    copy.altloc = atom.altloc == ' ' ? '\0' : atom.altloc;
    copy.occ = static_cast<float>(atom.occupancy);
    copy.b_iso = static_cast<float>(atom.b_factor);
    return selection.matches(copy);
}

// gemmi would go on from zero behind the largest number.
void check_numbers(const std::string& expression, const std::string& option) {
    constexpr const char* kDigits = "0123456789";
    std::size_t end = 0;
    for (std::size_t i = expression.find_first_of(kDigits); i < expression.size();
         i = expression.find_first_of(kDigits, end)) {
        end = std::min(expression.find_first_not_of(kDigits, i), expression.size());
        if (!integer(std::string_view(expression).substr(i, end - i)))
            throw UsageError(option + " " + shown(expression) +
                             ": a number larger than residue numbers may be; correct it");
    }
}

gemmi::Selection parse_selection(const std::string& expression, const std::string& option) {
    check_numbers(expression, option);
    try {
        gemmi::Selection selection(expression);
        // Older versions of gemmi take a single number for the first of a range without an end.
        const bool is_range = expression.substr(0, expression.find(';')).find('-') != std::string::npos;
        if (!selection.from_seqid.empty() && !is_range) selection.to_seqid = selection.from_seqid;
        return selection;
    } catch (const std::exception& error) {
        throw UsageError(option + " " + shown(expression) + ": " + printable(error.what(), kOfGemmi) +
                         "; write for instance //A/10-50 or (ALA,GLY) or CA[C]");
    }
}

bool has_chain(const RawModel& model, const gemmi::Selection& selection) {
    return std::any_of(model.residues.begin(), model.residues.end(),
                       [&](const RawResidue& residue) { return selection.matches(gemmi::Chain(residue.chain)); });
}

// "2" in "//A/-2", which is no negative number.
std::string end_of_open_range(const std::string& expression) {
    const std::size_t slash = expression.find("/-");
    if (slash == std::string::npos) return {};
    const std::size_t first = slash + 2;
    return expression.substr(first, expression.find_first_not_of("0123456789", first) - first);
}

bool has_atom(const RawModel& model, const gemmi::Selection& selection) {
    return std::any_of(model.atoms.begin(), model.atoms.end(),
                       [&](const RawAtom& atom) { return matches_atom(selection, atom); });
}

bool has_residue(const RawModel& model, const gemmi::Selection& selection) {
    return std::any_of(model.residues.begin(), model.residues.end(),
                       [&](const RawResidue& residue) { return matches_residue(selection, residue); });
}

// A bare name is a chain to gemmi; if there is no such chain, it is meant as atom names ("CA"), and if there is no such
// atom either, as residue names ("HEM").
std::string meant(const RawModel& model, const std::string& expression, const std::string& option) {
    const bool is_bare = expression.find_first_of("/([:;*!.- ") == std::string::npos;
    if (is_bare && has_chain(model, parse_selection(expression, option))) return expression;
    if (is_in_words(expression)) return in_gemmi_syntax(expression, option);
    if (!is_bare) return expression;
    const std::string of_atoms = "/*/*/*/" + expression;
    const std::string of_residues = "(" + expression + ")";
    const bool names_residues =
        !has_atom(model, parse_selection(of_atoms, option)) && has_residue(model, parse_selection(of_residues, option));
    return names_residues ? of_residues : of_atoms;
}

}  // namespace

namespace {

std::vector<bool> selected_by_one(const RawModel& model, const std::string& expression, int model_position,
                                  const std::string& option) {
    const gemmi::Selection selection = parse_selection(meant(model, expression, option), option);
    std::vector<bool> selected(model.atoms.size(), false);
    if (selection.mdl != 0 && selection.mdl != model_position) return selected;
    std::vector<bool> in_residue(model.residues.size());
    std::transform(model.residues.begin(), model.residues.end(), in_residue.begin(),
                   [&](const RawResidue& residue) { return matches_residue(selection, residue); });
    for (std::size_t i = 0; i < model.atoms.size(); ++i) {
        selected[i] = in_residue[model.atoms[i].residue] && matches_atom(selection, model.atoms[i]);
    }
    return selected;
}

// Empty where it is taken as it stands.
std::string one_restated(const RawModel& model, const std::string& expression, const std::string& option) {
    std::string understood = meant(model, expression, option);
    const bool is_as_given = understood == expression || understood == "/*/*/*/" + expression;
    if (!is_as_given) return understood;
    const std::string last = end_of_open_range(expression);
    return last.empty() ? "" : "all residues up to " + last;
}

// The selections that an expression has with " + " between them.
std::vector<std::string> selections_in(const std::string& expression, const std::string& option) {
    constexpr std::string_view kAnd = " + ";
    std::vector<std::string> selections;
    for (std::size_t begin = 0; begin <= expression.size();) {
        const std::size_t end = std::min(expression.find(kAnd, begin), expression.size());
        selections.push_back(expression.substr(begin, end - begin));
        begin = end + kAnd.size();
    }
    if (selections.size() > 1 && std::any_of(selections.begin(), selections.end(), [](const std::string& selection) {
            return selection.find_first_not_of(' ') == std::string::npos;
        }))
        throw UsageError(option + " " + printable(expression, kOfWord) +
                         ": nothing stands beside a +; write for instance //A/10 + //A/20");
    return selections;
}

}  // namespace

std::vector<bool> selected_atoms(const RawModel& model, const std::string& expression, int model_position,
                                 const std::string& option) {
    std::vector<bool> selected(model.atoms.size());
    const std::vector<std::string> selections = selections_in(expression, option);
    for (const std::string& selection : selections) {
        const std::vector<bool> more = selected_by_one(model, selection, model_position, option);
        if (selections.size() > 1 && std::find(more.begin(), more.end(), true) == more.end())
            throw UsageError(option + " " + printable(expression, kOfWord) + ": " + printable(selection, kOfWord) +
                             " selects nothing; write for instance //A/10 + //A/20");
        std::transform(selected.begin(), selected.end(), more.begin(), selected.begin(), std::logical_or<>());
    }
    return selected;
}

std::string restated_selection(const RawModel& model, const std::string& expression, const std::string& option) {
    std::string all;
    bool is_as_given = true;
    for (const std::string& selection : selections_in(expression, option)) {
        const std::string restated = one_restated(model, selection, option);
        is_as_given = is_as_given && restated.empty();
        all.append(all.empty() ? "" : " + ").append(restated.empty() ? selection : restated);
    }
    return is_as_given ? "" : all;
}

std::vector<RawAssembly> assemblies_of(const gemmi::cif::Block& block) {
    return to_assemblies(gemmi::make_structure_from_block(block).assemblies);
}

RawModel parse_pdb(CleanPdb clean, const std::string& file) {
    return with_input_errors(file, [&] {
        const auto structure = gemmi::read_pdb_from_memory(clean.text.data(), clean.text.size(), file);
        return to_model(structure, std::move(clean), file);
    });
}

}  // namespace meniscus::reading
