// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the models of a PDB file begin and end, however oddly it marks them.
#include <algorithm>
#include <map>
#include <set>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/join_models.h"
#include "structure/pdb_screen.h"

namespace meniscus::reading {
namespace {

// Counts one kind of irregularity and remembers where it came first.
struct Irregularity {
    const char* text;
    std::size_t count = 0;
    std::size_t first_line = 0;

    void note(std::size_t line) {
        if (count++ == 0) first_line = line;
    }

    std::string message() const {
        std::string times = count > 1 ? " (" + std::to_string(count) + " times)" : "";
        return "line " + std::to_string(first_line) + ": " + text + times;
    }
};

// "MODEL        1", "MODEL", "MODEL1", "MODEL_1"; but not "MODELS".
bool is_pdb_model_record(std::string_view line) {
    constexpr std::string_view kModel = "MODEL";
    if (!line.starts_with(kModel)) return false;
    const char behind = line.size() > kModel.size() ? line[kModel.size()] : ' ';
    return (behind < 'A' || behind > 'Z') && (behind < 'a' || behind > 'z');
}

class ModelFinder {
public:
    explicit ModelFinder(std::string_view text) : lines_(text) {}

    template <class KindOf>
    PdbModels run(KindOf kind_of) {
        while (lines_.next()) read(kind_of(lines_.line()));
        if (open_ && explicit_) unclosed_.note(model_line_);
        close(lines_.end());
        return finish();
    }

private:
    void read(ModelLine kind) {
        const bool is_end = kind == ModelLine::End;
        if (kind == ModelLine::Atom) {
            if (!open_) begin_without_record();
            ++atoms_;
            chain_width_ = chain_width_of_record(lines_.line(), chain_width_);
        } else if (kind == ModelLine::Model) {
            begin_model(trimmed(lines_.line()).substr(5));
        } else if (is_end || kind == ModelLine::Endmdl) {
            if (open_ && explicit_ && is_end) unclosed_.note(model_line_);
            close(lines_.begin(), is_end ? lines_.number() : 0);
        }
    }

    void begin_without_record() {
        if (seen_explicit_) outside_.note(lines_.number());
        begin(false);
    }

    void begin_model(std::string_view rest) {
        if (open_ && explicit_) unclosed_.note(model_line_);
        close(lines_.begin());
        if (!seen_explicit_ && !result_.spans.empty()) outside_.note(result_.spans.front().first_line);
        const std::string number(trimmed(rest.substr(0, 12)));
        if (!integer(number)) unnumbered_.note(lines_.number());
        if (integer(number) && !numbers_.insert(number).second) {
            repeated_.note(lines_.number());
        }
        model_line_ = lines_.number();
        begin(true);
    }

    void begin(bool is_explicit) {
        open_ = true;
        explicit_ = is_explicit;
        seen_explicit_ = seen_explicit_ || is_explicit;
        begin_ = lines_.begin();
        first_line_ = lines_.number();
    }

    void close(std::size_t end, std::size_t end_record = 0) {
        if (open_) result_.spans.push_back({begin_, end, first_line_, atoms_, end_record, ChainWidth::Unknown});
        atoms_ = 0;
        open_ = false;
    }

    PdbModels finish() {
        for (PdbModelSpan& span : result_.spans) span.chain_width = chain_width_;
        for (const Irregularity& kind : {repeated_, unnumbered_, unclosed_, outside_}) {
            if (kind.count > 0) result_.warnings.push_back(kind.message());
        }
        return std::move(result_);
    }

    Lines lines_;
    PdbModels result_;
    std::set<std::string> numbers_;
    ChainWidth chain_width_ = ChainWidth::Unknown;
    bool open_ = false;
    bool explicit_ = false;
    bool seen_explicit_ = false;
    std::size_t begin_ = 0;
    std::size_t first_line_ = 0;
    std::size_t model_line_ = 0;
    std::size_t atoms_ = 0;  // of the model that is open
    Irregularity repeated_{"this MODEL number occurs more than once; models are counted by position"};
    Irregularity unnumbered_{"MODEL without a number; models are counted by position"};
    Irregularity unclosed_{
        "this MODEL is never closed by ENDMDL; it is taken to end at the next MODEL, END or the end"};
    Irregularity outside_{"atoms outside MODEL and ENDMDL; taken as a model of their own"};
};

ModelLine kind_in_pdb(std::string_view line) {
    if (is_atom_record(line)) return ModelLine::Atom;
    if (is_pdb_model_record(line)) return ModelLine::Model;
    if (line.starts_with("ENDMDL")) return ModelLine::Endmdl;
    return trimmed(line) == "END" ? ModelLine::End : ModelLine::Other;
}

// Calls read(line) for the first of atom records that follow each other with the same columns from 18 to `last`.
template <class Read>
void for_each_residue(std::string_view text, const PdbModelSpan& model, std::size_t last, Read read) {
    constexpr std::size_t kFirst = 18;
    std::string_view before;
    Lines lines(text.substr(model.begin, model.end - model.begin));
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (!is_atom_record(line) || line.size() < last) continue;
        const std::string_view residue = line.substr(kFirst - 1, last - kFirst + 1);
        if (residue != before) read(line);
        before = residue;
    }
}

using ResiduesOfChains = std::map<std::string, std::set<std::string_view>>;

ResiduesOfChains residues_of_chains(std::string_view text, const PdbModelSpan& model) {
    ResiduesOfChains residues;
    for_each_residue(text, model, 27, [&](std::string_view line) {
        residues[chain_of_record(line, model.chain_width)].insert(line.substr(17, 10));
    });
    return residues;
}

// Of atoms with coordinates, by the columns of their names and residues.
using PlacesOfAtoms = std::map<std::string_view, Vec3>;

std::map<std::string, PlacesOfAtoms> places_of_chains(std::string_view text, const PdbModelSpan& model) {
    std::map<std::string, PlacesOfAtoms> places;
    Lines lines(text.substr(model.begin, model.end - model.begin));
    while (lines.next()) {
        const std::string_view line = lines.line();
        if (!is_atom_record(line) || line.size() < kPdbCoordinatesEnd) continue;
        const auto x = finite_number(line.substr(30, 8));
        const auto y = finite_number(line.substr(38, 8));
        const auto z = finite_number(line.substr(46, 8));
        if (x && y && z)
            places[chain_of_record(line, model.chain_width)].emplace(line.substr(12, 15), Vec3{*x, *y, *z});
    }
    return places;
}

// Whether the atoms that both have are elsewhere: the other subunit of a homodimer, no second frame of the first.
bool lie_apart(const PlacesOfAtoms& known, const PlacesOfAtoms& other) {
    std::vector<Vec3> first;
    std::vector<Vec3> second;
    for (const auto& [name, place] : other) {
        const auto same = known.find(name);
        if (same == known.end()) continue;
        first.push_back(same->second);
        second.push_back(place);
    }
    return !first.empty() && !lie_on_each_other(first, second);
}

// Chains of the same name and residues that are not where the first model has them.
std::set<std::string> moved_chains(std::string_view text, const PdbModelSpan& first, const PdbModelSpan& other) {
    const std::map<std::string, PlacesOfAtoms> known = places_of_chains(text, first);
    std::set<std::string> moved;
    for (const auto& [chain, places] : places_of_chains(text, other)) {
        const auto same = known.find(chain);
        if (same != known.end() && lie_apart(same->second, places)) moved.insert(chain);
    }
    return moved;
}

}  // namespace

PdbModels find_models(std::string_view text, ModelLine (*kind_of)(std::string_view line)) {
    return ModelFinder(text).run(kind_of);
}

PdbModels find_pdb_models(std::string_view text) { return ModelFinder(text).run(kind_in_pdb); }

std::set<std::string> chains_of(std::string_view text, const PdbModelSpan& model) {
    std::set<std::string> chains;
    for_each_residue(text, model, 22,
                     [&](std::string_view line) { chains.insert(chain_of_record(line, model.chain_width)); });
    return chains;
}

std::set<std::string> namesakes_of(std::string_view text, const PdbModelSpan& first, const PdbModelSpan& other) {
    const ResiduesOfChains known = residues_of_chains(text, first);
    std::set<std::string> namesakes = moved_chains(text, first, other);
    for (const auto& [chain, residues] : residues_of_chains(text, other)) {
        const auto same = known.find(chain);
        if (same == known.end()) continue;
        const auto shared =
            std::count_if(residues.begin(), residues.end(),
                          [&, &there = same->second](std::string_view residue) { return there.contains(residue); });
        if (2 * static_cast<std::size_t>(shared) < residues.size()) namesakes.insert(chain);
    }
    return namesakes;
}

}  // namespace meniscus::reading
