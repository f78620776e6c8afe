// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/structure.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "meniscus/errors.h"
#include "reading/text.h"
#include "structure/gemmi/cif_file.h"
#include "structure/gemmi/gemmi_reader.h"
#include "structure/gro_reader.h"
#include "structure/input_file.h"
#include "structure/join_models.h"
#include "structure/make_structure.h"
#include "structure/pdb_screen.h"
#include "structure/pdbqt_reader.h"
#include "structure/pqr_reader.h"
#include "structure/sphere_readers.h"

namespace meniscus {
namespace {

using namespace reading;

// A loaded file that hands out its models one by one.
class ModelSource {
public:
    ModelSource(InputFile file, const ReadOptions& options)
        : file_(std::move(file)), assemblies_(!options.assembly.empty()) {
        if (is_pdb()) pdb_ = find_pdb_models(file_.text);
        if (file_.format == Format::Pqr) pdb_ = find_pqr_models(file_.text);
        if (file_.format == Format::Cif) cif_.emplace(file_.text, file_.path);
        if (file_.format == Format::Bcif) cif_.emplace(file_.text, file_.path, CifForm::Binary);
        if (file_.format == Format::Gro) gro_ = find_gro_frames(file_.text, file_.path);
        if (cif_ && model_count() > 1) partners_ = find_partners(cif_->chains_of_models());
        if (is_pdb() && pdb_.spans.size() > 1) partners_ = partners_in_pdb();
        if (!partners_.exist() && !are_copies()) different_sizes_ = different_sizes();
    }

    const InputFile& file() const { return file_; }

    const Partners& partners() const { return partners_; }

    int model_count() const {
        if (cif_) return cif_->model_count();
        return std::max<int>(1, static_cast<int>(pdb_.spans.size() + gro_.size()));
    }

    RawModel model(int position) const {
        if (position > model_count()) {
            throw InputError(file_.path + ": no model " + std::to_string(position) + "; there " +
                             (model_count() == 1 ? "is 1" : "are " + std::to_string(model_count())));
        }
        RawModel model = named_model(position);
        append_lines(model);
        if (!different_sizes_.empty()) model.warnings.push_back(different_sizes_);
        return model;
    }

    RawModel joined() const {
        std::vector<RawModel> models;
        for (int position = 1; position <= model_count(); ++position) models.push_back(named_model(position));
        RawModel model = join_models(std::move(models), file_.path);
        append_lines(model);
        return model;
    }

    // Whether the models are the copies that make up a biological unit, of which one is only a part.
    bool are_copies() const {
        return model_count() > 1 && is_biological_unit(file_.path) && !lie_on_each_other(parse(1), parse(2));
    }

    // Another model, one with atoms, where a MODEL record has none behind it; 0 if there is nothing of the kind.
    int filled_instead_of(int position) const {
        const auto& spans = pdb_.spans;
        if (spans.size() < 2 || spans.at(static_cast<std::size_t>(position) - 1).atoms > 0) return 0;
        const auto filled = std::find_if(spans.begin(), spans.end(), [](const auto& span) { return span.atoms > 0; });
        return filled == spans.end() ? 0 : static_cast<int>(filled - spans.begin()) + 1;
    }

private:
    bool is_pdb() const { return file_.format == Format::Pdb || file_.format == Format::Pdbqt; }

    RawModel named_model(int position) const {
        RawModel model = parse(position);
        complete_model(model);
        return model;
    }

    void append_lines(RawModel& model) const {
        append(model.notes, file_.notes);
        append(model.warnings, file_.warnings);
        append(model.warnings, pdb_.warnings);
    }

    std::vector<std::size_t> atoms_of_models() const {
        if (cif_) return cif_->atoms_of_models();
        std::vector<std::size_t> atoms;
        for (const PdbModelSpan& span : pdb_.spans) atoms.push_back(span.atoms);
        for (const GroFrame& frame : gro_) atoms.push_back(frame.atoms);
        return atoms;
    }

    std::string place_of_model(std::size_t i) const {
        if (cif_) return cif_->place_of_model(static_cast<int>(i) + 1);
        return "line " + std::to_string(gro_.empty() ? pdb_.spans[i].first_line : gro_[i].first_line);
    }

    // A warning, empty without such models. Partners are different, and so may be models that are put together.
    std::string different_sizes() const {
        const std::vector<std::size_t> atoms = atoms_of_models();
        const auto differs = [&](std::size_t count) { return count != atoms.front(); };
        const auto first = std::find_if(atoms.begin(), atoms.end(), differs);
        if (first == atoms.end()) return {};
        const auto count = std::count_if(first, atoms.end(), differs);
        return place_of_model(static_cast<std::size_t>(first - atoms.begin())) +
               ": this model has a different number of atoms from the first" +
               (count > 1 ? " (" + std::to_string(count) + " times)" : "");
    }

    // Of the two parts of a docked complex both may have a chain A; in other files the same name is a copy.
    Partners partners_in_pdb() const {
        std::vector<std::set<std::string>> chains;
        for (const PdbModelSpan& span : pdb_.spans) chains.push_back(chains_of(file_.text, span));
        Partners partners = find_partners(chains);
        partners.end_record = pdb_.spans[0].end_record;
        const bool is_pair = partners.end_record > 0 && pdb_.spans.size() == 2;
        if (is_pair) partners.namesakes = namesakes_of(file_.text, pdb_.spans[0], pdb_.spans[1]);
        return partners;
    }

    RawModel parse(int position) const {
        switch (file_.format) {
            case Format::Cif:
            case Format::Bcif:
                return cif_->model(position);
            case Format::Pqr:
                return parse_pqr(file_.text, pdb_.spans.at(static_cast<std::size_t>(position) - 1), file_.path);
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
        if (file_.format == Format::Pdbqt) return parse_pdbqt(file_.text, span, file_.path);
        return parse_pdb(screen_pdb(file_.text, span, file_.path, assemblies_), file_.path);
    }

    InputFile file_;
    bool assemblies_;
    PdbModels pdb_;
    std::vector<GroFrame> gro_;
    std::optional<CifFile> cif_;
    Partners partners_;
    std::string different_sizes_;
};

RawModel model_with_atoms(const ModelSource& source, int position, const ReadOptions& options) {
    RawModel model = source.model(position);
    if (const int other = source.filled_instead_of(position); other > 0)
        throw InputError(source.file().path + ": model " + std::to_string(position) +
                         " has no atoms; take another with " + options.spelling("model", std::to_string(other)));
    return model;
}

// What was taken of several models.
void tell_models(const ModelSource& source, const ReadOptions& options, RawModel& model) {
    const std::string count = std::to_string(source.model_count());
    if (options.join_models) {
        model.notes.push_back(count + " models put together");
    } else if (options.model == 1 && source.partners().exist()) {
        model.left_out = describe(source.partners()) + " (take all with " + options.spelling("model", "join") + ")";
        model.warnings.push_back(model.left_out);
    } else if (options.model == 1 && source.are_copies()) {
        model.warnings.push_back("model 1 of " + count + " taken, a part of the biological unit (take all with " +
                                 options.spelling("model", "join") + ")");
    } else {
        model.notes.push_back("model " + std::to_string(options.model) + " of " + count +
                              " taken (choose another with " + options.spelling("model", "N") + ")");
    }
}

Checksum checksum_of(const ReadOptions& options) { return options.checksum ? Checksum::Found : Checksum::LeftOut; }

Structure structure_from(InputFile file, const ReadOptions& options) {
    const ModelSource source(std::move(file), options);
    RawModel model = options.join_models ? source.joined() : model_with_atoms(source, options.model, options);
    if (source.model_count() > 1) tell_models(source, options, model);
    return make_structure(source.file(), model, options).structure;
}

std::string model_suffix(int position) {
    const std::string number = std::to_string(position);
    return "_m" + (number.size() < 2 ? "0" + number : number);
}

std::vector<Structure> structures_from(InputFile file, const ReadOptions& options) {
    const ModelSource source(std::move(file), options);
    std::vector<Structure> structures;
    for (int position = 1; position <= source.model_count(); ++position) {
        ReadOptions own = options;
        own.model = position;
        structures.push_back(make_structure(source.file(), model_with_atoms(source, position, options), own).structure);
        structures.back().name += model_suffix(position);
    }
    return structures;
}

}  // namespace

Structure read_structure(const std::string& path, const ReadOptions& options) {
    check_options(options);
    return structure_from(load_input(path, checksum_of(options)), options);
}

Structure parse_structure(std::string bytes, const std::string& name, const ReadOptions& options) {
    check_options(options);
    return structure_from(load_bytes(std::move(bytes), name, checksum_of(options)), options);
}

std::vector<Structure> read_all_models(const std::string& path, const ReadOptions& options) {
    check_options(options);
    return structures_from(load_input(path, checksum_of(options)), options);
}

std::vector<Structure> parse_all_models(std::string bytes, const std::string& name, const ReadOptions& options) {
    check_options(options);
    return structures_from(load_bytes(std::move(bytes), name, checksum_of(options)), options);
}

}  // namespace meniscus
