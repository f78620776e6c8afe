// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/altlocs.h"

#include <algorithm>
#include <map>
#include <string_view>
#include <tuple>

namespace meniscus::reading {
namespace {

using SiteKey = std::tuple<std::string_view, std::string_view, int, char>;

struct Alternative {
    char letter = ' ';
    double occupancy = 0.0;
};

// The alternatives of a site in the order in which the file brings them.
using Site = std::vector<Alternative>;

SiteKey key_of(const RawResidue& residue) {
    return {residue.chain, residue.segment, residue.number, residue.insertion_code};
}

void add(Site& site, const RawAtom& atom) {
    auto found = std::find_if(site.begin(), site.end(), [&](const Alternative& a) { return a.letter == atom.altloc; });
    if (found == site.end()) found = site.insert(site.end(), {atom.altloc, 0.0});
    found->occupancy += atom.occupancy;
}

char choice(const Site& site, const std::string& wanted) {
    const auto is_wanted = [&](const Alternative& a) { return wanted.size() == 1 && a.letter == wanted[0]; };
    if (std::any_of(site.begin(), site.end(), is_wanted)) return wanted[0];
    // Sums of the same occupancies in different order differ in the last bits: that is still a tie.
    constexpr double kTie = 1e-9;
    Alternative best = site.front();
    for (const Alternative& a : site) {
        if (a.occupancy > best.occupancy + kTie) best = a;
    }
    return best.letter;
}

}  // namespace

std::vector<std::uint32_t> choose_altlocs(const RawModel& model, const std::vector<std::uint32_t>& kept,
                                          const std::string& wanted) {
    std::map<SiteKey, Site> sites;
    for (const std::uint32_t i : kept) {
        const RawAtom& atom = model.atoms[i];
        if (atom.altloc != ' ') add(sites[key_of(model.residue_of(atom))], atom);
    }
    std::map<SiteKey, char> choices;
    for (const auto& [key, site] : sites) choices.emplace(key, choice(site, wanted));
    std::vector<std::uint32_t> result;
    std::copy_if(kept.begin(), kept.end(), std::back_inserter(result), [&](std::uint32_t i) {
        const RawAtom& atom = model.atoms[i];
        return atom.altloc == ' ' || choices.at(key_of(model.residue_of(atom))) == atom.altloc;
    });
    return result;
}

}  // namespace meniscus::reading
