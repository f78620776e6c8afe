// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <map>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "tables/identity_cells.h"

namespace meniscus {
namespace {

// Groups of chains, each numbered once however often pairs name it.
class Groups {
public:
    explicit Groups(const Structure& structure) : chains_(chains_of(structure)) {}

    std::uint32_t number_of(std::vector<std::string> names) {
        std::sort(names.begin(), names.end());
        names.erase(std::unique(names.begin(), names.end()), names.end());
        const auto found = numbers_.find(names);
        if (found != numbers_.end()) return found->second;
        const auto number = static_cast<std::uint32_t>(groups_.size());
        groups_.push_back(atoms_of(names));
        numbers_.emplace(std::move(names), number);
        return number;
    }

    const std::vector<AtomGroup>& groups() const { return groups_; }

private:
    AtomGroup atoms_of(const std::vector<std::string>& names) const {
        std::vector<bool> wanted(chains_.names.size(), false);
        for (const std::string& name : names) wanted[place_of(name)] = true;
        AtomGroup group;
        for (std::uint32_t i = 0; i < chains_.of_atom.size(); ++i)
            if (wanted[chains_.of_atom[i]]) group.push_back(i);
        return group;
    }

    std::size_t place_of(const std::string& name) const {
        const auto found = std::find(chains_.names.begin(), chains_.names.end(), name);
        if (found != chains_.names.end()) return static_cast<std::size_t>(found - chains_.names.begin());
        std::string known;
        for (const std::string& chain : chains_.names) known.append(known.empty() ? "" : ", ").append(chain);
        throw UsageError("there is no chain '" + name + "' among the kept atoms; there are " + known);
    }

    Chains chains_;
    std::map<std::vector<std::string>, std::uint32_t> numbers_;
    std::vector<AtomGroup> groups_;
};

void check_sides(const ChainPair& pair) {
    for (const std::string& name : pair.a)
        if (std::find(pair.b.begin(), pair.b.end(), name) != pair.b.end())
            throw UsageError("chain '" + name + "' is on both sides of an interface");
}

}  // namespace

std::vector<ChainPair> touching_chains(const Structure& structure, double probe) {
    check_match(structure, structure.atoms.size());
    const Chains chains = chains_of(structure);
    std::vector<ChainPair> pairs;
    for (const auto& [a, b] : touching_groups(structure.atoms, chains.of_atom, chains.names.size(), probe))
        pairs.push_back({{chains.names[a]}, {chains.names[b]}});
    return pairs;
}

std::vector<ChainInterface> chain_interfaces(const Structure& structure, std::span<const ChainPair> pairs,
                                             const MeasureOptions& options) {
    check_match(structure, structure.atoms.size());
    Groups groups(structure);
    std::vector<std::array<std::uint32_t, 2>> numbers;
    for (const ChainPair& pair : pairs) {
        check_sides(pair);
        numbers.push_back({groups.number_of(pair.a), groups.number_of(pair.b)});
    }
    std::vector<Interface> areas = measure_interfaces(structure.atoms, groups.groups(), numbers, options);
    std::vector<ChainInterface> interfaces;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        interfaces.push_back(
            {pairs[i], groups.groups()[numbers[i][0]], groups.groups()[numbers[i][1]], std::move(areas[i])});
    return interfaces;
}

}  // namespace meniscus
