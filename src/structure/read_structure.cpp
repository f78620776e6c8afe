// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/structure.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "meniscus/errors.h"
#include "radii/aliases.h"
#include "structure/assign_radii.h"
#include "structure/build_structure.h"
#include "structure/choose_atoms.h"
#include "structure/coincident.h"
#include "structure/gemmi/cif_file.h"
#include "structure/gemmi/gemmi_reader.h"
#include "structure/gro_reader.h"
#include "structure/input_file.h"
#include "structure/pdb_screen.h"
#include "structure/residue_kinds.h"
#include "structure/sphere_readers.h"

namespace meniscus {
namespace {

using namespace reading;

void append(std::vector<std::string>& lines, const std::vector<std::string>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

// A loaded file that hands out its models one by one.
class ModelSource {
public:
    ModelSource(const std::string& path, const ReadOptions& options)
        : file_(load_input(path, options.checksum ? Checksum::Found : Checksum::LeftOut)),
          assemblies_(!options.assembly.empty()) {
        if (file_.format == Format::Pdb) pdb_ = find_pdb_models(file_.text);
        if (file_.format == Format::Cif) cif_.emplace(file_.text, file_.path);
        if (file_.format == Format::Bcif) cif_.emplace(file_.text, file_.path, CifForm::Binary);
        if (file_.format == Format::Gro) gro_ = find_gro_frames(file_.text, file_.path);
    }

    const InputFile& file() const { return file_; }

    int model_count() const {
        if (cif_) return cif_->model_count();
        return std::max<int>(1, static_cast<int>(pdb_.spans.size() + gro_.size()));
    }

    RawModel model(int position) const {
        if (position > model_count()) {
            throw InputError(file_.path + ": no model " + std::to_string(position) + "; there " +
                             (model_count() == 1 ? "is 1" : "are " + std::to_string(model_count())));
        }
        RawModel model = parse(position);
        append(model.notes, file_.notes);
        append(model.warnings, pdb_.warnings);
        classify_residues(model);
        return model;
    }

private:
    RawModel parse(int position) const {
        switch (file_.format) {
            case Format::Cif:
            case Format::Bcif:
                return cif_->model(position);
            case Format::Pqr:
                return parse_pqr(file_.text, file_.path);
            case Format::Xyzr:
                return parse_xyzr(file_.text, file_.path);
            case Format::Xyzrn:
                return parse_xyzrn(file_.text, file_.path);
            case Format::Gro:
                return parse_gro(file_.text, gro_[static_cast<std::size_t>(position) - 1], file_.path);
            default:
                return parse_pdb_model(position);
        }
    }

    RawModel parse_pdb_model(int position) const {
        if (pdb_.spans.empty()) return {};
        const PdbModelSpan& span = pdb_.spans[static_cast<std::size_t>(position) - 1];
        return parse_pdb(screen_pdb(file_.text, span, file_.path, assemblies_), file_.path);
    }

    InputFile file_;
    bool assemblies_;
    PdbModels pdb_;
    std::vector<GroFrame> gro_;
    std::optional<CifFile> cif_;
};

void check_options(const ReadOptions& options) {
    if (options.model < 1) throw UsageError("--model " + std::to_string(options.model) + ": models are counted from 1");
    if (options.altloc.size() > 1) throw UsageError("--altloc " + options.altloc + ": must be one character");
}

[[noreturn]] void fail_empty(const std::string& path, bool had_atoms, const Chosen& chosen) {
    if (!had_atoms) throw InputError(path + ": no atoms in this file; check that it is the right one");
    std::vector<std::string> lines = chosen.notes;
    append(lines, chosen.warnings);
    std::string reasons;
    for (const std::string& line : lines) reasons += (reasons.empty() ? "" : "; ") + line;
    throw InputError(path + ": no atoms left" +
                     (reasons.empty() ? "; --chains or --select keep none" : ": " + reasons));
}

// The names of standard residues leave no doubt about elements; "CA" of another one may be carbon or calcium.
void tell_guessed_elements(const RawModel& model, Chosen& chosen) {
    std::size_t certain = 0;
    std::size_t doubtful = 0;
    for (const std::uint32_t i : chosen.atoms) {
        if (!model.atoms[i].guessed_element) continue;
        const std::string& residue = model.residue_of(model.atoms[i]).name;
        ++(is_amino_acid(residue) || is_nucleotide(residue) || is_water(residue) ? certain : doubtful);
    }
    if (certain > 0)
        chosen.notes.push_back(counted(certain, "element") + " taken from atom names: " + model.why_guessed);
    if (doubtful > 0)
        chosen.warnings.push_back(counted(doubtful, "element") +
                                  " in non-standard residues guessed from atom names: " + model.why_guessed);
}

Structure make_structure(const InputFile& file, const RawModel& model, const ReadOptions& options) {
    Chosen chosen = choose_atoms(model, options, file.path);
    const AssignedRadii radii = assign_radii(model, options, file.path, chosen);
    if (chosen.atoms.empty()) fail_empty(file.path, !model.atoms.empty(), chosen);
    tell_guessed_elements(model, chosen);
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
    if (structure.atoms.empty()) throw InputError(file.path + ": assembly " + options.assembly + " has no kept atoms");
    if (const std::size_t count = count_coincident(structure.atoms.centres); count > 0) {
        structure.warnings.push_back(counted(count, "atom") + " at exactly the position of another atom");
    }
    return structure;
}

std::string model_suffix(int position) {
    const std::string number = std::to_string(position);
    return "_m" + (number.size() < 2 ? "0" + number : number);
}

}  // namespace

Structure read_structure(const std::string& path, const ReadOptions& options) {
    check_options(options);
    const ModelSource source(path, options);
    RawModel model = source.model(options.model);
    if (source.model_count() > 1) {
        model.notes.push_back("model " + std::to_string(options.model) + " of " + std::to_string(source.model_count()) +
                              " taken (choose another with " + options.spelling("model", "N") + ")");
    }
    return make_structure(source.file(), model, options);
}

std::vector<Structure> read_all_models(const std::string& path, const ReadOptions& options) {
    check_options(options);
    const ModelSource source(path, options);
    std::vector<Structure> structures;
    for (int position = 1; position <= source.model_count(); ++position) {
        ReadOptions own = options;
        own.model = position;
        structures.push_back(make_structure(source.file(), source.model(position), own));
        structures.back().name += model_suffix(position);
    }
    return structures;
}

}  // namespace meniscus
