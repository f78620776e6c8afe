// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/join_models.h"

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

void append_model(RawModel& whole, RawModel part, const std::string& file) {
    if (whole.atoms.size() + part.atoms.size() > std::numeric_limits<std::uint32_t>::max())
        throw LimitError(file + ": more than 4294967295 atoms in all models; choose one with --model");
    const auto shift = static_cast<std::uint32_t>(whole.residues.size());
    for (RawAtom& atom : part.atoms) atom.residue += shift;
    std::move(part.atoms.begin(), part.atoms.end(), std::back_inserter(whole.atoms));
    std::move(part.residues.begin(), part.residues.end(), std::back_inserter(whole.residues));
}

// "chain A", "chains A, B, (blank)".
std::string list_of_chains(const std::set<std::string>& chains) {
    std::string list;
    for (const std::string& chain : chains)
        list.append(list.empty() ? "" : ", ").append(chain.empty() ? "(blank)" : printable(chain));
    return (chains.size() == 1 ? "chain " : "chains ") + list;
}

}  // namespace

RawModel join_models(std::vector<RawModel> models, const std::string& file) {
    ChainNames names(models);
    for (RawModel& model : models) {
        names.begin_model();
        for (RawResidue& residue : model.residues) residue.chain = names.name(residue.chain);
    }
    RawModel whole = std::move(models.front());
    for (std::size_t i = 1; i < models.size(); ++i) append_model(whole, std::move(models[i]), file);
    return whole;
}

std::set<std::string> partners_of_first(const ChainsOfModels& chains) {
    std::set<std::string> partners;
    for (const std::set<std::string>& of_model : chains) partners.insert(of_model.begin(), of_model.end());
    for (const std::string& chain : chains.front()) partners.erase(chain);
    return partners;
}

std::string tell_partners(const ChainsOfModels& chains, std::size_t end_record) {
    const std::set<std::string> partners = partners_of_first(chains);
    const std::string taken = list_of_chains(chains.front()) + " taken, ";
    const std::string left = list_of_chains(partners);
    if (end_record == 0)
        return taken + "of model 1 of " + std::to_string(chains.size()) + "; " + left +
               (partners.size() == 1 ? " is" : " are") + " only in others";
    return taken + "before END in line " + std::to_string(end_record) + "; " + left +
           (partners.size() == 1 ? " follows it" : " follow it");
}

}  // namespace meniscus::reading
