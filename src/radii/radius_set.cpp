// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "radii/radius_set.h"

#include <algorithm>

#include "radii/aliases.h"
#include "radii/tables.h"

namespace meniscus {
namespace {

// Calls `test` on each comma-separated item until one answers true.
template <class Test>
bool any_item(std::string_view list, Test test) {
    while (true) {
        const std::size_t comma = list.find(',');
        if (test(list.substr(0, comma))) return true;
        if (comma == std::string_view::npos) return false;
        list.remove_prefix(comma + 1);
    }
}

bool matches_name(std::string_view pattern, std::string_view name) {
    if (pattern.ends_with('*')) return name.starts_with(pattern.substr(0, pattern.size() - 1));
    return pattern == name;
}

bool matches_atom(std::string_view pattern, const AtomType& type) {
    const std::size_t at = pattern.find('@');
    if (at == std::string_view::npos) return matches_name(pattern, type.name);
    return pattern.substr(at + 1) == type.element && (at == 0 || matches_name(pattern.substr(0, at), type.name));
}

bool matches_residue(std::string_view pattern, const AtomType& type) {
    return pattern == "*" || pattern == type.residue || (type.n_terminal && pattern == "NTERM");
}

// A rule applies to an atom under the names it came with or under its canonical ones.
std::optional<double> first_match(std::span<const RadiusRule> rules, const AtomType& type) {
    const CanonicalNames names = canonical_names(type.residue, type.name);
    const AtomType canonical{names.residue, names.atom, type.element, type.n_terminal};
    const auto found = std::find_if(rules.begin(), rules.end(), [&](const RadiusRule& rule) {
        return matches(rule, type) || matches(rule, canonical);
    });
    return found == rules.end() ? std::nullopt : std::optional(found->radius);
}

std::string key_of(const AtomType& type) {
    std::string key(type.residue);
    return key.append(1, '\t')
        .append(type.name)
        .append(1, '\t')
        .append(type.element)
        .append(type.n_terminal ? "+" : "");
}

}  // namespace

bool matches(const RadiusRule& rule, const AtomType& type) {
    return any_item(rule.residue, [&](std::string_view item) { return matches_residue(item, type); }) &&
           any_item(rule.atom, [&](std::string_view item) { return matches_atom(item, type); });
}

std::optional<RadiusSet> find_radius_set(std::string_view name) {
    if (name == "bondi") return RadiusSet{"bondi", false, kBondiRules, nullptr};
    if (name == "united") return RadiusSet{"united", true, kUnitedRules, nullptr};
    if (name == "protor") return RadiusSet{"protor", true, kProtorRules, nullptr};
    if (name == "naccess") return RadiusSet{"naccess", true, kNaccessRules, nullptr};
    if (name == "parse") return RadiusSet{"parse", false, kParseRules, nullptr};
    return std::nullopt;
}

std::string radius_set_names() { return "bondi, united, protor, naccess, parse"; }

std::optional<double> RadiusTyper::find(const AtomType& type) {
    const auto [entry, is_new] = known_.try_emplace(key_of(type));
    if (is_new) entry->second = first_match(set_.rules, type);
    return entry->second;
}

}  // namespace meniscus
