// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/assign_radii.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <set>

#include "meniscus/errors.h"
#include "meniscus/file_name.h"
#include "meniscus/list_of_counts.h"
#include "radii/element_radii.h"
#include "radii/rule_file.h"
#include "reading/text.h"
#include "structure/hydrogens.h"

namespace meniscus::reading {
namespace {

constexpr double kDisulfideBond = 2.5;  // Å; the bond has 2.05, sulphurs not bonded stay 3.4 apart

RadiusSet named_set(const ReadOptions& options) {
    const std::string& name = options.radii;
    if (auto set = find_radius_set(name)) return *set;
    std::error_code ignored;
    if (std::filesystem::exists(name, ignored)) return read_radius_rules(name);
    throw UsageError(options.spelling("radii", name) + ": neither a radius set nor a file; choose one of " +
                     radius_set_names() + ", auto, or a file of rules");
}

RadiusSet choose_set(const ReadOptions& options, const HydrogenCount& hydrogens) {
    if (options.radii != "auto") return named_set(options);
    const bool keeps = options.hydrogens == HydrogenPolicy::Keep && hydrogens.all > 0;
    const bool complete = options.hydrogens == HydrogenPolicy::Auto && hydrogens.is_complete();
    return *find_radius_set(keeps || complete ? "bondi" : "united");
}

void drop_hydrogens(const RawModel& model, Chosen& chosen) {
    const std::size_t count = std::erase_if(chosen.atoms, [&](std::uint32_t i) { return is_hydrogen(model.atoms[i]); });
    chosen.drop("hydrogens", count);
}

void apply_hydrogens(const RawModel& model, const ReadOptions& options, const RadiusSet& set,
                     const HydrogenCount& hydrogens, Chosen& chosen) {
    if (options.hydrogens == HydrogenPolicy::Keep) {
        if (set.united && hydrogens.all > 0) {
            throw UsageError(options.spelling("hydrogens", "keep") + ": the radii of " + set.name +
                             " already include the hydrogens; use " + options.spelling("radii", "bondi"));
        }
        return;
    }
    if (hydrogens.all == 0) return;
    const bool asked = options.hydrogens == HydrogenPolicy::Drop;
    const bool incomplete = !model.has_radii && !hydrogens.is_complete();
    if (!asked && !set.united && !incomplete) return;
    drop_hydrogens(model, chosen);
    if (asked) return;
    const std::string left_out = counted(hydrogens.all, "hydrogen") + " left out, ";
    const bool set_was_asked_for = options.radii != "auto";
    if (set.united && (set_was_asked_for || !incomplete))
        chosen.notes.push_back(left_out + "the radii of " + file_name(set.name) +
                               " already include them (keep them with " + options.spelling("radii", "bondi") + ")");
    else
        chosen.warnings.push_back(left_out + "too few to be complete (keep them with " +
                                  options.spelling("hydrogens", "keep") + ")");
}

// Residues in which an atom's radius depends on more than names: disulfides and charged amino ends.
class Surroundings {
public:
    Surroundings(const RawModel& model, const std::vector<std::uint32_t>& kept) : model_(model) {
        for (const std::uint32_t i : kept) {
            const RawAtom& atom = model.atoms[i];
            if (atom.name == "SG") sulphurs_.push_back(i);
            if (is_third_hydrogen(atom)) amino_ends_.insert(atom.residue);
        }
        find_disulfides();
    }

    AtomType type_of(const RawAtom& atom) const {
        const RawResidue& residue = model_.residue_of(atom);
        const bool bridged = residue.name == "CYS" && disulfides_.contains(atom.residue);
        return {bridged ? std::string_view("CYX") : std::string_view(residue.name), atom.name, atom.element,
                amino_ends_.contains(atom.residue)};
    }

private:
    // Of -NH3+; proline, which has one hydrogen less, shows its second.
    bool is_third_hydrogen(const RawAtom& atom) const {
        if (!atom.name.starts_with('H')) return false;
        const RawResidue& residue = model_.residue_of(atom);
        const bool is_proline = residue.name == "PRO";
        return is_amino(residue.name) &&
               (atom.name == "H3" || atom.name == "HT3" || atom.name == "HN3" ||
                (is_proline && (atom.name == "H2" || atom.name == "HT2" || atom.name == "HN2")));
    }

    static bool is_amino(const std::string& residue) { return residue.size() >= 3; }  // nucleotides: DT has an H3 too

    void find_disulfides() {
        std::sort(sulphurs_.begin(), sulphurs_.end(), [&](std::uint32_t a, std::uint32_t b) {
            return model_.atoms[a].centre.x < model_.atoms[b].centre.x;
        });
        for (std::size_t i = 0; i < sulphurs_.size(); ++i) {
            const RawAtom& a = model_.atoms[sulphurs_[i]];
            for (std::size_t j = i + 1; j < sulphurs_.size(); ++j) {
                const RawAtom& b = model_.atoms[sulphurs_[j]];
                if (b.centre.x - a.centre.x > kDisulfideBond) break;
                const bool bonded = squared_norm(b.centre - a.centre) < kDisulfideBond * kDisulfideBond;
                if (bonded && a.residue != b.residue && a.centre != b.centre)
                    disulfides_.insert({a.residue, b.residue});
            }
        }
    }

    const RawModel& model_;
    std::vector<std::uint32_t> sulphurs_;
    std::set<std::uint32_t> disulfides_;
    std::set<std::uint32_t> amino_ends_;
};

// Types atoms by a set and keeps count of those it does not know.
class Assigner {
public:
    Assigner(const RawModel& model, RadiusSet set, const std::vector<std::uint32_t>& kept)
        : typer_(std::move(set)), surroundings_(model, kept) {}

    double radius(const RawAtom& atom) {
        const AtomType type = surroundings_.type_of(atom);
        if (const auto found = typer_.find(type)) return *found;
        ++unknown_[std::string(type.residue) + " " + std::string(type.name)];
        const auto element = element_radius(type.element);
        if (!element) ++without_element_;
        return element ? element->radius : kUnknownElementRadius;
    }

    void report(const ReadOptions& options, const std::string& file, Chosen& chosen) const {
        if (unknown_.empty()) return;
        const std::string& set = typer_.set().name;
        const std::string types = list_of_counts(unknown_);
        if (options.strict_radii) {
            throw InputError(file + ": set " + set + " has no radius for " + types +
                             "; give them in a file of rules or leave out " + options.spelling("strict_radii", ""));
        }
        std::string line = "not in radius set " + file_name(set) + ", given the radii of their elements: " + types;
        if (without_element_ > 0) {
            line += " (" + std::to_string(without_element_) + " of unknown element, given 1.70)";
        }
        chosen.warnings.push_back(line + "; give others with " + options.spelling("radii", "FILE"));
    }

private:
    RadiusTyper typer_;
    Surroundings surroundings_;
    std::map<std::string, std::size_t> unknown_;
    std::size_t without_element_ = 0;
};

// Leaves out atoms of radius 0; radii and atoms stay in step. Force fields have hydrogens of radius 0; another atom may
// be one that the file's author had no radius for.
void drop_zero_radii(const RawModel& model, AssignedRadii& radii, Chosen& chosen) {
    std::size_t kept = 0;
    bool only_hydrogens = true;
    for (std::size_t i = 0; i < radii.values.size(); ++i) {
        if (radii.values[i] <= 0.0) {
            only_hydrogens = only_hydrogens && is_hydrogen(model.atoms[chosen.atoms[i]]);
            continue;
        }
        radii.values[kept] = radii.values[i];
        chosen.atoms[kept++] = chosen.atoms[i];
    }
    const std::size_t count = radii.values.size() - kept;
    radii.values.resize(kept);
    chosen.atoms.resize(kept);
    chosen.drop("zero_radius", count);
    if (count == 0) return;
    std::vector<std::string>& lines = only_hydrogens ? chosen.notes : chosen.warnings;
    lines.push_back(counted(count, only_hydrogens ? "hydrogen" : "atom") +
                    " of radius 0 left out: a radius of 0 excludes an atom");
}

AssignedRadii own_radii(const RawModel& model, const ReadOptions& options, Chosen& chosen) {
    if (options.hydrogens == HydrogenPolicy::Drop) drop_hydrogens(model, chosen);
    AssignedRadii radii{"file", {}};
    for (const std::uint32_t i : chosen.atoms) radii.values.push_back(model.atoms[i].radius);
    return radii;
}

AssignedRadii radii_of_set(const RawModel& model, const ReadOptions& options, const std::string& file, Chosen& chosen) {
    const HydrogenCount hydrogens = count_hydrogens(model, chosen.atoms);
    const RadiusSet set = choose_set(options, hydrogens);
    AssignedRadii radii{set.name, {}};
    Assigner assigner(model, set, chosen.atoms);
    apply_hydrogens(model, options, set, hydrogens, chosen);
    radii.values.reserve(chosen.atoms.size());
    for (const std::uint32_t i : chosen.atoms) radii.values.push_back(assigner.radius(model.atoms[i]));
    assigner.report(options, file, chosen);
    return radii;
}

}  // namespace

AssignedRadii assign_radii(const RawModel& model, const ReadOptions& options, const std::string& file, Chosen& chosen) {
    const bool own = model.has_radii && options.radii == "auto";
    if (!own && !model.has_names) {
        throw UsageError(options.spelling("radii", options.radii) + ": " + file +
                         " has radii but no atom names; use its own radii with " + options.spelling("radii", "auto"));
    }
    AssignedRadii radii = own ? own_radii(model, options, chosen) : radii_of_set(model, options, file, chosen);
    drop_zero_radii(model, radii, chosen);
    return radii;
}

}  // namespace meniscus::reading
