// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/interfaces.h"

#include <algorithm>
#include <map>
#include <set>

#include "meniscus/errors.h"
#include "space/box_tree.h"
#include "space/canonical_atoms.h"

namespace meniscus {
namespace {

constexpr double kSortingCell = 4.0;  // Å: a few atoms per cell

Atoms subset(const Atoms& atoms, const AtomGroup& group) {
    Atoms part;
    for (const std::uint32_t i : group) {
        part.centres.push_back(atoms.centres[i]);
        part.radii.push_back(atoms.radii[i]);
    }
    return part;
}

void check_group(const Atoms& atoms, const AtomGroup& group) {
    if (group.empty()) throw UsageError("an interface needs at least one atom on each side");
    const auto exists = [&](std::uint32_t i) { return i < atoms.size(); };
    if (!std::all_of(group.begin(), group.end(), exists)) throw UsageError("a group names an atom that does not exist");
}

AtomGroup united(const AtomGroup& a, const AtomGroup& b) {
    AtomGroup both = a;
    both.insert(both.end(), b.begin(), b.end());
    std::vector<std::uint32_t> sorted = both;
    std::sort(sorted.begin(), sorted.end());
    if (std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end())
        throw UsageError("an atom is on both sides of an interface, or twice on one");
    return both;
}

// Names in Measures::disputed count the atoms of the subset; say which one.
void add_dispute(const Measures& measures, const char* which, Interface& interface) {
    if (measures.agreed) return;
    interface.agreed = false;
    for (const std::string& name : measures.disputed)
        interface.disputed.push_back(name + " (counted within " + which + ")");
}

std::vector<InterfaceAtom> compare(std::span<const AtomMeasure> alone, std::span<const AtomMeasure> in_complex) {
    std::vector<InterfaceAtom> atoms(alone.size());
    for (std::size_t i = 0; i < alone.size(); ++i)
        atoms[i] = {alone[i].sas_area, in_complex[i].sas_area, alone[i].ses_area(), in_complex[i].ses_area()};
    return atoms;
}

Interface make_interface(const Measures& a, const Measures& b, const Measures& both) {
    Interface interface;
    interface.sas_a = a.totals.sas_area;
    interface.sas_b = b.totals.sas_area;
    interface.sas_ab = both.totals.sas_area;
    interface.ses_a = a.totals.ses_area;
    interface.ses_b = b.totals.ses_area;
    interface.ses_ab = both.totals.ses_area;
    for (const Measures* measures : {&a, &b, &both}) {
        interface.sas_error += measures->errors.sas_area;
        interface.ses_error += measures->errors.ses_area;
    }
    const std::span<const AtomMeasure> in_complex(both.atoms);
    interface.atoms_a = compare(a.atoms, in_complex.first(a.atoms.size()));
    interface.atoms_b = compare(b.atoms, in_complex.subspan(a.atoms.size()));
    add_dispute(a, "the first group", interface);
    add_dispute(b, "the second group", interface);
    add_dispute(both, "both groups", interface);
    return interface;
}

struct Member {
    std::uint32_t group;
    double radius;
};

// The atoms of groups that have the centre of each distinct atom.
std::vector<std::vector<Member>> members_at(const CanonicalAtoms& sorted, const Atoms& atoms,
                                            std::span<const std::uint32_t> group) {
    using Place = std::array<double, 3>;
    const auto place = [](const Vec3& centre) { return Place{centre.x, centre.y, centre.z}; };
    std::map<Place, std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < sorted.size(); ++i) numbers[place(sorted.centres[i])] = i;
    std::vector<std::vector<Member>> found(sorted.size());
    for (std::size_t i = 0; i < atoms.size(); ++i)
        if (group[i] != kNone) found[numbers.at(place(atoms.centres[i]))].push_back({group[i], atoms.radii[i]});
    return found;
}

}  // namespace

std::vector<Interface> measure_interfaces(const Atoms& atoms, std::span<const AtomGroup> groups,
                                          std::span<const std::array<std::uint32_t, 2>> pairs,
                                          const MeasureOptions& options) {
    MeasureOptions areas = options;
    areas.cavities = false;
    areas.depth = false;
    std::map<std::uint32_t, Measures> alone;
    const auto measure_alone = [&](std::uint32_t g) -> const Measures& {
        const auto found = alone.find(g);
        if (found != alone.end()) return found->second;
        if (g >= groups.size()) throw UsageError("a pair names a group that does not exist");
        check_group(atoms, groups[g]);
        return alone.emplace(g, measure(subset(atoms, groups[g]), areas)).first->second;
    };
    std::vector<Interface> interfaces;
    for (const auto& [a, b] : pairs) {
        const Measures& of_a = measure_alone(a);
        const Measures& of_b = measure_alone(b);
        interfaces.push_back(make_interface(of_a, of_b, measure(subset(atoms, united(groups[a], groups[b])), areas)));
    }
    return interfaces;
}

Interface measure_interface(const Atoms& atoms, const AtomGroup& a, const AtomGroup& b, const MeasureOptions& options) {
    const std::array<AtomGroup, 2> groups{a, b};
    const std::array<std::uint32_t, 2> pair{0, 1};
    return measure_interfaces(atoms, groups, std::span(&pair, 1), options).front();
}

std::vector<std::array<std::uint32_t, 2>> touching_groups(const Atoms& atoms, std::span<const std::uint32_t> group,
                                                          std::size_t groups, double probe) {
    if (group.size() != atoms.size()) throw UsageError("one group per atom is needed");
    const auto known = [&](std::uint32_t g) { return g < groups || g == kNone; };
    if (!std::all_of(group.begin(), group.end(), known)) throw UsageError("an atom's group does not exist");
    const CanonicalAtoms sorted = canonical_atoms(atoms, kSortingCell);
    const std::vector<std::vector<Member>> here = members_at(sorted, atoms, group);
    std::vector<Box> boxes;
    for (std::size_t i = 0; i < sorted.size(); ++i)
        boxes.push_back(Box{sorted.centres[i], sorted.centres[i]}.grown(sorted.radii[i] + probe));
    const BoxTree tree(boxes);
    std::set<std::array<std::uint32_t, 2>> pairs;
    for (std::uint32_t i = 0; i < sorted.size(); ++i) {
        tree.for_each_overlapping(boxes[i], [&](std::uint32_t j) {
            const double squared_distance = squared_norm(sorted.centres[i] - sorted.centres[j]);
            for (const Member& a : here[i])
                for (const Member& b : here[j]) {
                    const double reach = a.radius + b.radius + 2.0 * probe;
                    if (a.group < b.group && squared_distance <= reach * reach) pairs.insert({a.group, b.group});
                }
        });
    }
    return {pairs.begin(), pairs.end()};
}

}  // namespace meniscus
