// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Radius sets: ordered rules from (residue, atom) to a radius, and the sets that come with the program.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

namespace meniscus {

/// What a radius is chosen by; upper case, without blanks. element is a symbol ("C", "FE") or empty.
struct AtomType {
    std::string_view residue;
    std::string_view name;
    std::string_view element;
    bool n_terminal = false;  ///< of a charged terminal amino group
};

/// One line of a set; the first rule that matches decides.
///
/// residue  comma-separated names, * for any, NTERM for a charged terminal amino group
/// atom     comma-separated: NAME, PREFIX*, @EL (an element), NAME@EL (both), * (any atom)
/// radius   Å; 0 means that the atom does not exist for the surface
struct RadiusRule {
    std::string_view residue;
    std::string_view atom;
    double radius = 0.0;
};

/// True if the rule applies to the atom exactly as named (no aliases).
bool matches(const RadiusRule& rule, const AtomType& type);

/// An ordered list of rules under a name. Copies share the text of their rules.
struct RadiusSet {
    std::string name;
    bool united = false;  ///< radii stand for heavy atoms with their hydrogens: hydrogens are always dropped
    std::span<const RadiusRule> rules;
    std::shared_ptr<const void> storage;  ///< owns what the rules of a user's set point into
};

/// The built-in set of that name (bondi, united, protor, naccess, parse), or nothing.
std::optional<RadiusSet> find_radius_set(std::string_view name);

/// "bondi, united, protor, naccess, parse", for messages.
std::string radius_set_names();

/// Chooses radii by one set, remembering the types already seen.
class RadiusTyper {
public:
    explicit RadiusTyper(RadiusSet set) : set_(std::move(set)) {}

    const RadiusSet& set() const { return set_; }

    /// The radius by the first rule that matches the atom as named or under its canonical names (aliases.h), Å;
    /// nothing if no rule does.
    std::optional<double> find(const AtomType& type);

private:
    RadiusSet set_;
    std::unordered_map<std::string, std::optional<double>> known_;
};

}  // namespace meniscus
