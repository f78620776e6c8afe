// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/join_models.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>
#include <utility>

#include "meniscus/errors.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

// Gives every chain of every model a name of its own.
class ChainNames {
public:
    explicit ChainNames(const std::vector<RawModel>& models) {
        for (const RawModel& model : models)
            for (const RawResidue& residue : model.residues) taken_.insert(residue.chain);
    }

    void begin_model() { of_model_.clear(); }

    const std::string& name(const std::string& chain) {
        const auto [found, is_new] = of_model_.try_emplace(chain);
        if (is_new) found->second = next_name(chain);
        return found->second;
    }

private:
    std::string next_name(const std::string& chain) {
        std::size_t& count = counts_[chain];
        if (++count == 1) return chain;
        std::string name = chain + "-" + std::to_string(count);
        while (!taken_.insert(name).second) name = chain + "-" + std::to_string(++count);
        return name;
    }

    std::set<std::string> taken_;
    std::map<std::string, std::size_t> counts_;
    std::map<std::string, std::string> of_model_;
};

std::vector<Vec3> places_of(const RawModel& model) {
    std::vector<Vec3> places;
    for (const RawAtom& atom : model.atoms) places.push_back(atom.centre);
    return places;
}

void append_model(RawModel& whole, RawModel part, const std::string& file) {
    if (whole.atoms.size() + part.atoms.size() > std::numeric_limits<std::uint32_t>::max())
        throw LimitError(file + ": more than 4294967295 atoms in all models; choose one model");
    const auto shift = static_cast<std::uint32_t>(whole.residues.size());
    for (RawAtom& atom : part.atoms) atom.residue += shift;
    std::move(part.atoms.begin(), part.atoms.end(), std::back_inserter(whole.atoms));
    std::move(part.residues.begin(), part.residues.end(), std::back_inserter(whole.residues));
}

// "chain A", "chains A, B, (blank)"; at most six names.
std::string list_of_chains(const std::set<std::string>& chains) {
    constexpr std::size_t kMostNames = 6;
    std::string list;
    std::size_t count = 0;
    for (const std::string& chain : chains) {
        if (++count > kMostNames) break;
        list.append(list.empty() ? "" : ", ").append(chain.empty() ? "(blank)" : printable(chain));
    }
    if (chains.size() > kMostNames) list += " and " + std::to_string(chains.size() - kMostNames) + " more";
    return (chains.size() == 1 ? "chain " : "chains ") + list;
}

}  // namespace

bool lie_on_each_other(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    constexpr double kNear = 4.0;  // Å
    if (a.size() != b.size()) return false;
    std::size_t near = 0;
    for (std::size_t i = 0; i < a.size(); ++i) near += squared_norm(a[i] - b[i]) < kNear * kNear ? 1 : 0;
    return 2 * near > a.size();
}

bool lie_on_each_other(const RawModel& a, const RawModel& b) {
    std::vector<Vec3> places_a = places_of(a);
    std::vector<Vec3> places_b = places_of(b);
    const std::size_t common = std::min(places_a.size(), places_b.size());
    places_a.resize(common);
    places_b.resize(common);
    return lie_on_each_other(places_a, places_b);
}

RawModel join_models(std::vector<RawModel> models, const std::string& file) {
    const bool is_ensemble = models.size() > 1 && lie_on_each_other(models[0], models[1]);
    ChainNames names(models);
    for (RawModel& model : models) {
        names.begin_model();
        for (RawResidue& residue : model.residues) residue.chain = names.name(residue.chain);
    }
    RawModel whole = std::move(models.front());
    for (std::size_t i = 1; i < models.size(); ++i) append_model(whole, std::move(models[i]), file);
    if (is_ensemble)
        whole.warnings.emplace_back(
            "models 1 and 2 lie on each other, as in an ensemble, where one model is the molecule");
    return whole;
}

Partners find_partners(const std::vector<std::set<std::string>>& chains) {
    Partners partners{.taken = chains.front(), .others = {}, .namesakes = {}};
    for (const std::set<std::string>& of_model : chains)
        for (const std::string& chain : of_model)
            if (!partners.taken.contains(chain)) partners.others.insert(chain);
    return partners;
}

std::string describe(const Partners& partners) {
    std::string left;
    if (!partners.others.empty()) left = list_of_chains(partners.others);
    if (!partners.namesakes.empty())
        left += (left.empty() ? "another " : " and another ") + list_of_chains(partners.namesakes);
    const bool one = partners.others.size() + partners.namesakes.size() == 1;
    const std::string taken = list_of_chains(partners.taken) + " taken, ";
    if (partners.end_record == 0) return taken + "of model 1; " + left + (one ? " is" : " are") + " only in others";
    return taken + "before END in line " + std::to_string(partners.end_record) + "; " + left +
           (one ? " follows it" : " follow it");
}

}  // namespace meniscus::reading
