// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "tables/identity_cells.h"

namespace meniscus {
namespace {

/// What a side names: a chain, residues by name, or such residues of a chain.
struct Partner {
    std::string chain;                  ///< empty: of any
    std::vector<std::string> residues;  ///< empty: all

    bool is_ligand() const { return !residues.empty(); }
};

std::vector<std::string> split_at_commas(const std::string& text) {
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == ',')
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

Partner partner_of(const std::string& name) {
    const std::size_t open = name.find('(');
    if (open == std::string::npos || name.back() != ')') return {name, {}};
    Partner partner{name.substr(0, open), split_at_commas(name.substr(open + 1, name.size() - open - 2))};
    for (const std::string& residue : partner.residues)
        if (residue.empty()) throw UsageError("'" + name + "' lacks the name of a residue; write for instance (HEM)");
    return partner;
}

std::string listed(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list.append(list.empty() ? "" : ", ").append(name);
    return list;
}

// The atoms of chains and ligands, by the names of a structure.
class Partners {
public:
    Partners(const Structure& structure, OptionSpelling spelling)
        : structure_(structure), spelling_(spelling), chains_(chains_of(structure)) {}

    /// One truth value for every atom.
    std::vector<bool> atoms_of(const std::string& name) const {
        const Partner partner = partner_of(name);
        std::vector<bool> is_part(chains_.of_atom.size());
        for (std::size_t i = 0; i < is_part.size(); ++i) is_part[i] = has(partner, i);
        if (std::find(is_part.begin(), is_part.end(), true) == is_part.end()) refuse(partner, name);
        return is_part;
    }

private:
    bool has(const Partner& partner, std::size_t atom) const {
        if ((!partner.chain.empty() || !partner.is_ligand()) && chains_.names[chains_.of_atom[atom]] != partner.chain)
            return false;
        const auto& wanted = partner.residues;
        return wanted.empty() ||
               std::find(wanted.begin(), wanted.end(), residue_at(structure_, atom).name) != wanted.end();
    }

    [[noreturn]] void refuse(const Partner& partner, const std::string& name) const {
        if (partner.is_ligand()) refuse_ligand(partner, name);
        std::string message = "there is no chain '" + name + "' among the kept atoms" + what_there_is();
        if (is_residue(name)) message += "; the residues of that name are (" + name + ")";
        throw UsageError(message);
    }

    std::string what_there_is() const {
        std::vector<std::string> named;
        std::copy_if(chains_.names.begin(), chains_.names.end(), std::back_inserter(named),
                     [](const std::string& chain) { return !chain.empty(); });
        if (named.empty()) return ", whose chains have no names; give a file that names them, such as PDB or mmCIF";
        return "; there are " + listed(named) + (named.size() < chains_.names.size() ? " and one without a name" : "");
    }

    [[noreturn]] void refuse_ligand(const Partner& partner, const std::string& name) const {
        for (const std::string& residue : partner.residues)
            if (structure_.left_out_ligands.contains(residue))
                throw UsageError(residue + " was left out with the other ligands; keep them with " + hetero("ligands"));
        throw UsageError("there is no residue " + name + " among the kept atoms; ligands are kept with " +
                         hetero("ligands") + ", ions, too, with " + hetero("all"));
    }

    std::string hetero(const char* value) const {
        return spelling_ != nullptr ? spelling_("hetero", value) : std::string("hetero = ") + value;
    }

    bool is_residue(const std::string& name) const {
        return structure_.left_out_ligands.contains(name) ||
               std::any_of(structure_.residues.begin(), structure_.residues.end(),
                           [&](const Residue& residue) { return residue.name == name; });
    }

    const Structure& structure_;
    OptionSpelling spelling_;
    Chains chains_;
};

// Groups of atoms, each numbered once however often pairs name it.
class Groups {
public:
    std::uint32_t number_of(AtomGroup group) {
        const auto [place, is_new] = numbers_.emplace(group, static_cast<std::uint32_t>(groups_.size()));
        if (is_new) groups_.push_back(std::move(group));
        return place->second;
    }

    const std::vector<AtomGroup>& groups() const { return groups_; }

private:
    std::map<AtomGroup, std::uint32_t> numbers_;
    std::vector<AtomGroup> groups_;
};

/// The atoms of one side of a pair. Ligands go before the chains that they belong to.
struct NamedAtoms {
    std::vector<bool> in_chains;
    std::vector<bool> in_ligands;
};

void add(std::vector<bool>& all, const std::vector<bool>& more) {
    all.resize(more.size());
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = all[i] || more[i];
}

NamedAtoms atoms_named(const Partners& partners, const std::vector<std::string>& names, std::size_t atoms) {
    NamedAtoms side{std::vector<bool>(atoms), std::vector<bool>(atoms)};
    for (const std::string& name : names)
        add(partner_of(name).is_ligand() ? side.in_ligands : side.in_chains, partners.atoms_of(name));
    return side;
}

AtomGroup group_of(const NamedAtoms& side, const NamedAtoms& other) {
    AtomGroup group;
    for (std::uint32_t i = 0; i < side.in_chains.size(); ++i)
        if (side.in_ligands[i] || (side.in_chains[i] && !other.in_ligands[i])) group.push_back(i);
    return group;
}

std::string joined_names(const std::vector<std::string>& names) {
    std::string list;
    for (const std::string& name : names) list.append(list.empty() ? "" : ",").append(name);
    return list;
}

void check_sides(const ChainPair& pair) {
    for (const std::string& name : pair.a)
        if (std::find(pair.b.begin(), pair.b.end(), name) != pair.b.end())
            throw UsageError((partner_of(name).is_ligand() ? "'" : "chain '") + name +
                             "' is on both sides of an interface");
}

void check_groups(const ChainPair& pair, const AtomGroup& a, const AtomGroup& b) {
    if (a.empty() || b.empty())
        throw UsageError("the ligands of the other side are all that there is of '" +
                         joined_names(a.empty() ? pair.a : pair.b) + "'");
    std::vector<std::uint32_t> both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(both));
    if (!both.empty())
        throw UsageError("'" + joined_names(pair.a) + "' and '" + joined_names(pair.b) + "' have atoms in common");
}

}  // namespace

std::vector<std::string> split_group(const std::string& text) {
    constexpr std::string_view kWord = "chain ";
    const bool is_in_words = text.starts_with(kWord);
    std::vector<std::string> names{""};
    int depth = 0;
    for (const char c : is_in_words ? text.substr(kWord.size()) : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (depth == 0 && (c == ',' || (is_in_words && c == '+')))
            names.emplace_back();
        else if (c != ' ')
            names.back() += c;
    }
    return names;
}

std::optional<ChainPair> split_pair(const std::string& text) {
    const std::size_t colon = text.find(':');
    if (colon == std::string::npos || text.find(':', colon + 1) != std::string::npos) return std::nullopt;
    ChainPair pair{split_group(text.substr(0, colon)), split_group(text.substr(colon + 1))};
    for (const auto* group : {&pair.a, &pair.b})
        if (std::find(group->begin(), group->end(), "") != group->end()) return std::nullopt;
    return pair;
}

std::vector<ChainPair> touching_chains(const Structure& structure, double probe) {
    check_match(structure, structure.atoms.size());
    const Chains chains = chains_of(structure);
    std::vector<ChainPair> pairs;
    for (const auto& [a, b] : touching_groups(structure.atoms, chains.of_atom, chains.names.size(), probe))
        pairs.push_back({{chains.names[a]}, {chains.names[b]}});
    return pairs;
}

std::vector<ChainInterface> chain_interfaces(const Structure& structure, std::span<const ChainPair> pairs,
                                             const MeasureOptions& options, OptionSpelling spelling) {
    check_match(structure, structure.atoms.size());
    const Partners partners(structure, spelling);
    Groups groups;
    std::vector<std::array<std::uint32_t, 2>> numbers;
    for (const ChainPair& pair : pairs) {
        check_sides(pair);
        const NamedAtoms a = atoms_named(partners, pair.a, structure.atoms.size());
        const NamedAtoms b = atoms_named(partners, pair.b, structure.atoms.size());
        check_groups(pair, group_of(a, b), group_of(b, a));
        numbers.push_back({groups.number_of(group_of(a, b)), groups.number_of(group_of(b, a))});
    }
    std::vector<Interface> areas = measure_interfaces(structure.atoms, groups.groups(), numbers, options);
    std::vector<ChainInterface> interfaces;
    for (std::size_t i = 0; i < pairs.size(); ++i)
        interfaces.push_back(
            {pairs[i], groups.groups()[numbers[i][0]], groups.groups()[numbers[i][1]], std::move(areas[i])});
    return interfaces;
}

}  // namespace meniscus
