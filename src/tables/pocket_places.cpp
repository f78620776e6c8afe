// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/pocket_places.h"

#include <algorithm>
#include <array>
#include <map>
#include <numeric>
#include <set>
#include <utility>

#include "meniscus/errors.h"
#include "meniscus/interfaces.h"
#include "meniscus/tables.h"

namespace meniscus {
namespace {

constexpr double kBonded = 2.1;  // Å: no two atoms of different molecules are as close, but for metals

using Centre = std::array<double, 3>;

Centre centre_of(const Structure& structure, std::size_t atom) {
    const Vec3& p = structure.atoms.centres[atom];
    return {p.x, p.y, p.z};
}

std::set<Centre> centres_of(const Structure& structure) {
    std::set<Centre> centres;
    for (std::size_t i = 0; i < structure.atoms.size(); ++i) centres.insert(centre_of(structure, i));
    return centres;
}

// What is left out beside a molecule: "; beside the molecule are HEM, ZN".
std::string names_beside(const Structure& whole, const std::set<Centre>& own) {
    std::set<std::string> names;
    for (std::size_t i = 0; i < whole.atoms.size(); ++i)
        if (!own.contains(centre_of(whole, i))) names.insert(whole.residues[whole.labels[i].residue].name);
    if (names.empty()) return "; there are no ligands beside the molecule";
    std::string text;
    for (const std::string& name : names) text.append(text.empty() ? "; beside the molecule are " : ", ").append(name);
    return text;
}

bool are_bonded(const Atoms& atoms, const std::vector<std::uint32_t>& a, const std::vector<std::uint32_t>& b) {
    return std::any_of(a.begin(), a.end(), [&](std::uint32_t i) {
        return std::any_of(b.begin(), b.end(), [&](std::uint32_t j) {
            return squared_norm(atoms.centres[i] - atoms.centres[j]) < kBonded * kBonded;
        });
    });
}

// Lists of residues that are bonded, each in the order of the structure, and the lists in that of their first residues.
std::vector<std::vector<std::uint32_t>> molecules_of(
    const Atoms& atoms, const std::map<std::uint32_t, std::vector<std::uint32_t>>& atoms_of) {
    std::vector<std::vector<std::uint32_t>> molecules;
    for (const auto& [residue, own] : atoms_of) {
        std::vector<std::uint32_t> joined{residue};
        std::vector<std::vector<std::uint32_t>> others;
        for (std::vector<std::uint32_t>& molecule : molecules) {
            const bool touches = std::any_of(molecule.begin(), molecule.end(), [&, &mine = own](std::uint32_t other) {
                return are_bonded(atoms, mine, atoms_of.at(other));
            });
            if (touches)
                joined.insert(joined.end(), molecule.begin(), molecule.end());
            else
                others.push_back(std::move(molecule));
        }
        std::sort(joined.begin(), joined.end());
        others.push_back(std::move(joined));
        molecules = std::move(others);
    }
    std::sort(molecules.begin(), molecules.end());
    return molecules;
}

NamedPlace place_of_ligand(const Structure& whole, const std::vector<std::uint32_t>& residues,
                           const std::map<std::uint32_t, std::vector<std::uint32_t>>& atoms_of, double reach) {
    NamedPlace place;
    place.place.reach = reach;
    for (const std::uint32_t residue : residues) {
        if (place.name.empty()) place.name = spaced_label(whole.residues[residue]);
        for (const std::uint32_t atom : atoms_of.at(residue)) {
            place.place.points.push_back(whole.atoms.centres[atom]);
            place.ligand.centres.push_back(whole.atoms.centres[atom]);
            place.ligand.radii.push_back(whole.atoms.radii[atom]);
        }
    }
    if (place.name.empty()) place.name = "ligand";
    if (residues.size() > 1) place.name += " + " + std::to_string(residues.size() - 1);
    return place;
}

}  // namespace

std::vector<NamedPlace> places_of_selection(const Structure& molecule, const Structure& whole,
                                            const std::string& expression, double reach, const std::string& option) {
    const std::set<Centre> own = centres_of(molecule);
    std::vector<bool> selected;
    try {
        selected = select_atoms(whole, expression, option);
    } catch (const UsageError& error) {
        throw UsageError(error.what() + names_beside(whole, own));
    }
    NamedPlace beside{expression, {{}, reach}, {}};
    std::map<std::uint32_t, std::vector<std::uint32_t>> atoms_of;  // of residues that are ligands
    for (std::uint32_t i = 0; i < selected.size(); ++i) {
        if (!selected[i]) continue;
        if (own.contains(centre_of(whole, i)))
            beside.place.points.push_back(whole.atoms.centres[i]);
        else
            atoms_of[whole.labels[i].residue].push_back(i);
    }
    // Ions are places where nothing else is selected, as in "(ZN)", but not with a chain.
    const bool has_more =
        !beside.place.points.empty() ||
        std::any_of(atoms_of.begin(), atoms_of.end(), [](const auto& of) { return of.second.size() > 1; });
    if (has_more) std::erase_if(atoms_of, [](const auto& of) { return of.second.size() == 1; });
    std::vector<NamedPlace> places;
    if (!beside.place.points.empty()) places.push_back(std::move(beside));
    for (const std::vector<std::uint32_t>& ligand : molecules_of(whole.atoms, atoms_of))
        places.push_back(place_of_ligand(whole, ligand, atoms_of, reach));
    return places;
}

LigandFit fit_ligand(const Atoms& molecule, const Atoms& ligand, const Pocket& pocket, double probe) {
    LigandFit fit{.atoms = ligand.size(), .inside = pocket.points_inside};
    Atoms both = ligand;
    AtomGroup of_ligand(ligand.size());
    std::iota(of_ligand.begin(), of_ligand.end(), 0U);
    AtomGroup near;
    for (std::size_t i = 0; i < molecule.size(); ++i) {
        const double reach = molecule.radii[i] + 2.0 * probe;
        const bool counts = std::any_of(of_ligand.begin(), of_ligand.end(), [&](std::uint32_t j) {
            const double most = reach + ligand.radii[j];
            return squared_norm(molecule.centres[i] - ligand.centres[j]) < most * most;
        });
        if (!counts) continue;
        near.push_back(static_cast<std::uint32_t>(both.size()));
        both.centres.push_back(molecule.centres[i]);
        both.radii.push_back(molecule.radii[i]);
    }
    if (near.empty()) {
        fit.area = measure(ligand, {.probe = probe, .cavities = false}).totals.sas_area;
        return fit;
    }
    const Interface interface = measure_interface(both, near, of_ligand, {.probe = probe});
    fit.area = interface.sas_b;
    for (const InterfaceAtom& atom : interface.atoms_b) fit.buried_area += atom.buried_sas();
    return fit;
}

}  // namespace meniscus
