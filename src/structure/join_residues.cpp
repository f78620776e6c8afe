// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/join_residues.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>

namespace meniscus::reading {
namespace {

using Number = std::tuple<std::string_view, int, char>;                 // chain, number, insertion code
using Name = std::pair<std::string_view, std::string_view>;             // residue, mmCIF label of its chain
using AtomName = std::tuple<std::string_view, std::string_view, char>;  // residue, atom, alternative

// A residue and its alternatives with other names; of each, the first piece.
struct Site {
    std::uint32_t first = 0;  ///< the first residue of all
    std::map<Name, std::uint32_t> residues;
    std::set<AtomName> atoms;
};

// What a residue is a piece of: itself, or a residue before it; and the first residue of the site.
struct Whole {
    std::uint32_t residue = 0;
    std::uint32_t first_of_site = 0;
};

// Of all residues with the same number, those that belong together.
class Sites {
public:
    explicit Sites(const std::vector<RawResidue>& residues) : residues_(residues) {}

    // Precondition: residues come in their order.
    Whole add(std::uint32_t residue, const std::vector<AtomName>& atoms) {
        last_site_ = site_for(residue, atoms);
        last_residue_ = residue;
        Site& site = sites_[last_site_];
        site.atoms.insert(atoms.begin(), atoms.end());
        const RawResidue& raw = residues_[residue];
        return {site.residues.try_emplace({raw.name, raw.label_chain}, residue).first->second, site.first};
    }

private:
    std::size_t site_for(std::uint32_t residue, const std::vector<AtomName>& atoms) {
        const bool follows = !sites_.empty() && last_residue_ + 1 == residue;
        if (follows && has_room(last_site_, atoms)) return last_site_;
        // A piece from elsewhere in the file is taken only where there is no doubt to which site it belongs.
        std::vector<std::size_t>& same_segment = of_segment_[residues_[residue].segment];
        if (same_segment.size() == 1 && has_room(same_segment.front(), atoms)) return same_segment.front();
        if (same_segment.empty() && sites_.size() == 1 && has_room(0, atoms)) return 0;
        same_segment.push_back(sites_.size());
        sites_.emplace_back().first = residue;
        return same_segment.back();
    }

    bool has_room(std::size_t site, const std::vector<AtomName>& atoms) const {
        return std::none_of(atoms.begin(), atoms.end(),
                            [&](const AtomName& name) { return sites_[site].atoms.contains(name); });
    }

    const std::vector<RawResidue>& residues_;
    std::vector<Site> sites_;
    std::map<std::string_view, std::vector<std::size_t>> of_segment_;
    std::size_t last_site_ = 0;
    std::uint32_t last_residue_ = 0;
};

std::vector<std::vector<std::uint32_t>> residues_with_same_number(const std::vector<RawResidue>& residues) {
    std::map<Number, std::vector<std::uint32_t>> all;
    for (std::uint32_t r = 0; r < residues.size(); ++r)
        all[{residues[r].chain, residues[r].number, residues[r].insertion_code}].push_back(r);
    std::vector<std::vector<std::uint32_t>> repeated;
    for (auto& [number, group] : all)
        if (group.size() > 1) repeated.push_back(std::move(group));
    return repeated;
}

// Which atoms every residue has.
class AtomsOfResidues {
public:
    explicit AtomsOfResidues(const RawModel& model)
        : model_(model), ends_(model.residues.size() + 1), atoms_(model.atoms.size()) {
        for (const RawAtom& atom : model.atoms) ++ends_[atom.residue + 1];
        std::partial_sum(ends_.begin(), ends_.end(), ends_.begin());
        std::vector<std::size_t> next(ends_);
        for (std::uint32_t i = 0; i < model.atoms.size(); ++i) atoms_[next[model.atoms[i].residue]++] = i;
    }

    std::vector<AtomName> names(std::uint32_t residue) const {
        std::vector<AtomName> names;
        for (std::size_t k = ends_[residue]; k < ends_[residue + 1]; ++k) {
            const RawAtom& atom = model_.atoms[atoms_[k]];
            names.emplace_back(model_.residues[residue].name, atom.name, atom.altloc);
        }
        return names;
    }

private:
    const RawModel& model_;
    std::vector<std::size_t> ends_;
    std::vector<std::uint32_t> atoms_;
};

// What becomes of every residue.
std::vector<Whole> find_wholes(const RawModel& model, const std::vector<std::vector<std::uint32_t>>& groups) {
    std::vector<Whole> wholes(model.residues.size());
    for (std::uint32_t r = 0; r < wholes.size(); ++r) wholes[r] = {r, r};
    const AtomsOfResidues atoms(model);
    for (const auto& group : groups) {
        Sites sites(model.residues);
        for (const std::uint32_t residue : group) wholes[residue] = sites.add(residue, atoms.names(residue));
    }
    return wholes;
}

// Leaves out the residues that are pieces of others.
void take_together(RawModel& model, const std::vector<Whole>& wholes) {
    std::vector<std::uint32_t> place(wholes.size());
    std::vector<RawResidue> residues;
    for (std::uint32_t r = 0; r < wholes.size(); ++r) {
        const std::uint32_t whole = wholes[r].residue;
        place[r] = whole == r ? static_cast<std::uint32_t>(residues.size()) : place[whole];
        if (whole == r)
            residues.push_back(std::move(model.residues[r]));
        else if (model.residues[r].in_sequence)
            residues[place[r]].in_sequence = true;
    }
    model.residues = std::move(residues);
    for (RawAtom& atom : model.atoms) atom.residue = place[atom.residue];
}

}  // namespace

void join_residues(RawModel& model) {
    const auto groups = residues_with_same_number(model.residues);
    if (groups.empty()) return;
    const std::vector<Whole> wholes = find_wholes(model, groups);
    for (std::uint32_t r = 0; r < wholes.size(); ++r)
        model.residues[r].segment = model.residues[wholes[r].first_of_site].segment;
    take_together(model, wholes);
}

}  // namespace meniscus::reading
