// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/altlocs.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

#include "radii/aliases.h"

namespace meniscus::reading {
namespace {

using SiteKey = std::tuple<std::string_view, std::string_view, int, char>;

struct Alternative {
    char letter = ' ';
    double occupancy = 0.0;
};

// The alternatives of a site or an atom in the order in which the file brings them.
using Alternatives = std::vector<Alternative>;

SiteKey key_of(const RawResidue& residue) {
    return {residue.chain, residue.segment, residue.number, residue.insertion_code};
}

void add(Alternatives& alternatives, const RawAtom& atom) {
    auto found = std::find_if(alternatives.begin(), alternatives.end(),
                              [&](const Alternative& a) { return a.letter == atom.altloc; });
    if (found == alternatives.end()) found = alternatives.insert(alternatives.end(), {atom.altloc, 0.0});
    found->occupancy += atom.occupancy;
}

char best_of(const Alternatives& alternatives) {
    // Sums of the same occupancies in different order differ in the last bits: that is still a tie.
    constexpr double kTie = 1e-9;
    Alternative best = alternatives.front();
    for (const Alternative& a : alternatives) {
        if (a.occupancy > best.occupancy + kTie) best = a;
    }
    return best.letter;
}

char choice(const Alternatives& site, const std::string& wanted) {
    const auto is_wanted = [&](const Alternative& a) { return wanted.size() == 1 && a.letter == wanted[0]; };
    return std::any_of(site.begin(), site.end(), is_wanted) ? wanted[0] : best_of(site);
}

// Atoms of a polymer that no alternative of a side chain stands for.
bool is_main_chain(std::string_view residue, std::string_view atom) {
    constexpr auto kNames = std::to_array<std::string_view>(
        {"N", "CA", "C", "O", "P", "OP1", "OP2", "O5'", "C5'", "C4'", "O4'", "C3'", "O3'", "C2'", "C1'"});
    return std::find(kNames.begin(), kNames.end(), canonical_names(residue, atom).atom) != kNames.end();
}

// Atoms that have alternatives: those with a letter, and those without one whose residue has the same atom with one.
// Such a blank is an alternative like any letter, as where a program adds a second place and leaves the first as it
// was.
class AtomsWithAlternatives {
public:
    AtomsWithAlternatives(const RawModel& model, const std::vector<std::uint32_t>& kept) {
        for (const std::uint32_t i : kept)
            if (const RawAtom& atom = model.atoms[i]; atom.altloc != ' ') lettered_.insert({atom.residue, atom.name});
    }

    bool contain(const RawAtom& atom) const {
        return atom.altloc != ' ' || (!lettered_.empty() && lettered_.contains({atom.residue, atom.name}));
    }

private:
    std::set<std::pair<std::uint32_t, std::string_view>> lettered_;
};

// The letter of every site, which may be a blank.
std::map<SiteKey, char> choices_of_sites(const RawModel& model, const std::vector<std::uint32_t>& kept,
                                         const AtomsWithAlternatives& alternatives, const std::string& wanted) {
    std::map<SiteKey, Alternatives> sites;
    for (const std::uint32_t i : kept) {
        const RawAtom& atom = model.atoms[i];
        if (alternatives.contain(atom)) add(sites[key_of(model.residue_of(atom))], atom);
    }
    std::map<SiteKey, char> choices;
    for (const auto& [key, site] : sites) choices.emplace(key, choice(site, wanted));
    return choices;
}

// Atoms of one name at a site.
struct NamedAtoms {
    bool settled = false;  ///< there is one of the site's letter, or one without alternatives
    Alternatives others;   ///< letters that are not the site's
};

class Chooser {
public:
    Chooser(const RawModel& model, const std::vector<std::uint32_t>& kept, const std::string& wanted)
        : model_(model), alternatives_(model, kept), sites_(choices_of_sites(model, kept, alternatives_, wanted)) {
        for (const std::uint32_t i : kept) {
            const RawAtom& atom = model.atoms[i];
            if (const auto site = sites_.find(key_of(model.residue_of(atom))); site != sites_.end()) note(atom, *site);
        }
    }

    // Precondition: atoms come in file order, each once.
    bool takes(const RawAtom& atom) {
        if (!has_alternatives(atom) || is_of_its_site(atom)) return true;
        std::vector<Vec3>& taken = taken_[key_of(model_.residue_of(atom))];
        if (!is_substitute(atom) || is_renamed(atom, taken)) return false;
        taken.push_back(atom.centre);
        return true;
    }

    bool has_alternatives(const RawAtom& atom) const { return alternatives_.contain(atom); }

    bool is_of_its_site(const RawAtom& atom) const { return sites_.at(key_of(model_.residue_of(atom))) == atom.altloc; }

private:
    // Whether an atom that is not of its site's letter is the best of an atom that lacks this letter.
    bool is_substitute(const RawAtom& atom) const {
        const RawResidue& residue = model_.residue_of(atom);
        const SiteKey site = key_of(residue);
        if (has_letter_of_site_.contains({site, residue.name}))
            return is_best(in_residue_.at({site, residue.name, atom.name}), atom);
        return residue.kind == ResidueKind::Polymer && is_main_chain(residue.name, atom.name) &&
               is_best(at_site_.at({site, atom.name}), atom);
    }

    // Alternatives may have names of their own, as hydrogen and deuterium have in a neutron structure; different atoms
    // are never as close as these.
    static bool is_renamed(const RawAtom& atom, const std::vector<Vec3>& taken) {
        constexpr double kSamePlace = 0.5;  // Å
        return std::any_of(taken.begin(), taken.end(), [&](const Vec3& place) {
            return squared_norm(place - atom.centre) < kSamePlace * kSamePlace;
        });
    }

    void note(const RawAtom& atom, const std::pair<const SiteKey, char>& site) {
        const std::string& residue = model_.residue_of(atom).name;
        NamedAtoms& here = in_residue_[{site.first, residue, atom.name}];
        NamedAtoms& anywhere = at_site_[{site.first, atom.name}];
        if (!has_alternatives(atom) || atom.altloc == site.second) {
            here.settled = anywhere.settled = true;
            taken_[site.first].push_back(atom.centre);
        } else {
            add(here.others, atom);
            add(anywhere.others, atom);
        }
        if (has_alternatives(atom) && atom.altloc == site.second) has_letter_of_site_.insert({site.first, residue});
    }

    static bool is_best(const NamedAtoms& atoms, const RawAtom& atom) {
        return !atoms.settled && best_of(atoms.others) == atom.altloc;
    }

    const RawModel& model_;
    AtomsWithAlternatives alternatives_;
    std::map<SiteKey, char> sites_;
    std::map<SiteKey, std::vector<Vec3>> taken_;  // places of atoms that stay
    std::map<std::tuple<SiteKey, std::string_view, std::string_view>, NamedAtoms> in_residue_;
    std::map<std::tuple<SiteKey, std::string_view>, NamedAtoms> at_site_;
    std::set<std::tuple<SiteKey, std::string_view>> has_letter_of_site_;
};

}  // namespace

AltlocChoice choose_altlocs(const RawModel& model, const std::vector<std::uint32_t>& kept, const std::string& wanted) {
    Chooser chooser(model, kept, wanted);
    AltlocChoice result;
    for (const std::uint32_t i : kept) {
        const RawAtom& atom = model.atoms[i];
        if (!chooser.takes(atom)) continue;
        result.atoms.push_back(i);
        const bool is_as_asked = !chooser.has_alternatives(atom) ||
                                 (wanted.empty() ? chooser.is_of_its_site(atom) : atom.altloc == wanted[0]);
        result.substitutes += is_as_asked ? 0 : 1;
    }
    return result;
}

}  // namespace meniscus::reading
