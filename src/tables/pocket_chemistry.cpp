// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/describe_pockets.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>

#include "radii/aliases.h"
#include "tables/hydropathy.h"

namespace meniscus {
namespace {

struct Parent {
    std::string_view name;
    std::string_view parent;
};
constexpr std::array kParents{
    Parent{"MSE", "MET"}, Parent{"HID", "HIS"}, Parent{"HIE", "HIS"}, Parent{"HIP", "HIS"}, Parent{"HSD", "HIS"},
    Parent{"HSE", "HIS"}, Parent{"HSP", "HIS"}, Parent{"CYX", "CYS"}, Parent{"CYM", "CYS"}, Parent{"CSO", "CYS"},
    Parent{"CME", "CYS"}, Parent{"OCS", "CYS"}, Parent{"CAS", "CYS"}, Parent{"ASH", "ASP"}, Parent{"GLH", "GLU"},
    Parent{"LYN", "LYS"}, Parent{"LLP", "LYS"}, Parent{"KCX", "LYS"}, Parent{"MLY", "LYS"}, Parent{"TPO", "THR"},
    Parent{"SEP", "SER"}, Parent{"PTR", "TYR"},
};

std::string_view parent_of(std::string_view residue) {
    const auto* found =
        std::find_if(kParents.begin(), kParents.end(), [&](const Parent& p) { return p.name == residue; });
    return found == kParents.end() ? residue : found->parent;
}

bool is_one_of(std::string_view word, std::initializer_list<std::string_view> words) {
    return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_aromatic_carbon(std::string_view residue, std::string_view atom) {
    if (residue == "PHE" || residue == "TYR") return is_one_of(atom, {"CG", "CD1", "CD2", "CE1", "CE2", "CZ"});
    if (residue == "TRP") return is_one_of(atom, {"CG", "CD1", "CD2", "CE2", "CE3", "CZ2", "CZ3", "CH2"});
    return residue == "HIS" && is_one_of(atom, {"CG", "CD2", "CE1"});
}

bool is_polar_carbon(std::string_view residue, std::string_view atom) {
    if (residue == "ARG") return is_one_of(atom, {"CZ", "CD"});
    if (residue == "ASN" || residue == "ASP") return atom == "CG";
    if (residue == "GLN" || residue == "GLU") return atom == "CD";
    if (residue == "SER" || residue == "THR") return atom == "CB";
    return residue == "LYS" && atom == "CE";
}

AtomClass carbon(std::string_view residue, std::string_view atom) {
    if (atom == "C" || atom == "CA") return AtomClass::BackboneCarbon;
    if (is_aromatic_carbon(residue, atom)) return AtomClass::AromaticCarbon;
    return is_polar_carbon(residue, atom) ? AtomClass::PolarCarbon : AtomClass::AliphaticCarbon;
}

AtomClass nitrogen(std::string_view residue, std::string_view atom) {
    if (atom == "N") return AtomClass::BackboneNitrogen;
    if (residue == "ARG" || residue == "LYS") return AtomClass::CationicNitrogen;
    return residue == "HIS" ? AtomClass::HistidineNitrogen : AtomClass::AmideNitrogen;
}

AtomClass oxygen(std::string_view residue, std::string_view atom) {
    if (is_one_of(atom, {"O", "OXT", "OT1", "OT2"})) return AtomClass::BackboneOxygen;
    if (residue == "ASP" || residue == "GLU") return AtomClass::AnionicOxygen;
    return is_one_of(residue, {"SER", "THR", "TYR"}) ? AtomClass::HydroxylOxygen : AtomClass::AmideOxygen;
}

AtomClass class_of(std::string_view residue, const AtomLabel& atom) {
    if (atom.element == "C") return carbon(residue, atom.name);
    if (atom.element == "N") return nitrogen(residue, atom.name);
    if (atom.element == "O") return oxygen(residue, atom.name);
    return is_one_of(atom.element, {"S", "SE", "Se"}) ? AtomClass::Sulfur : AtomClass::Other;
}

bool is_donor(std::string_view residue, AtomClass kind) {
    switch (kind) {
        case AtomClass::BackboneNitrogen:
            return residue != "PRO";
        case AtomClass::AmideNitrogen:
        case AtomClass::CationicNitrogen:
        case AtomClass::HistidineNitrogen:
        case AtomClass::HydroxylOxygen:
            return true;
        default:
            return false;
    }
}

bool is_acceptor(AtomClass kind) {
    switch (kind) {
        case AtomClass::BackboneOxygen:
        case AtomClass::AmideOxygen:
        case AtomClass::HydroxylOxygen:
        case AtomClass::AnionicOxygen:
        case AtomClass::HistidineNitrogen:
            return true;
        default:
            return false;
    }
}

}  // namespace

std::vector<AtomClass> atom_classes(const Structure& structure) {
    std::vector<AtomClass> classes;
    classes.reserve(structure.labels.size());
    for (const AtomLabel& atom : structure.labels)
        classes.push_back(class_of(parent_of(structure.residues[atom.residue].name), atom));
    return classes;
}

std::string doubt_of_ranking(const Structure& structure, double spacing) {
    const auto has = [&](auto is_one) {
        return std::any_of(structure.residues.begin(), structure.residues.end(),
                           [&](const Residue& residue) { return is_one(parent_of(residue.name)); });
    };
    const bool has_nucleotides = has(is_nucleotide);
    std::string what;
    const auto add = [&](const std::string& more) { what.append(what.empty() ? "" : " and ").append(more); };
    if (structure.radii_set != "united") add(structure.radii_set + " radii");
    if (has([](std::string_view name) { return !is_amino_acid(name) && !is_nucleotide(name) && !is_water(name); }))
        add("hetero atoms");
    if (spacing != 1.0) add("another spacing");
    if (has_nucleotides) add("nucleic acids");
    if (what.empty()) return "";
    return "the ranking was fitted to heavy atoms of proteins with united radii at 1 Å; with " + what + " " +
           (has_nucleotides ? "do not rely on its order and scores" : "its scores are less sure") +
           ", volumes and areas are not concerned";
}

PocketChemistry describe_pocket(const Pocket& pocket, const Structure& structure) {
    PocketChemistry result;
    double area = 0.0;
    for (const WallAtom& wall : pocket.wall) {
        const AtomLabel& atom = structure.labels[wall.atom];
        const std::string_view residue = parent_of(structure.residues[atom.residue].name);
        area += wall.area;
        result.hydrophobicity += wall.area * hydropathy_of(residue).value_or(0.0);
        if (wall.area <= kLiningArea) continue;
        const AtomClass kind = class_of(residue, atom);
        result.atoms.push_back(wall.atom);
        result.residues.push_back(atom.residue);
        result.donors += static_cast<std::size_t>(is_donor(residue, kind));
        result.acceptors += static_cast<std::size_t>(is_acceptor(kind));
    }
    if (area > 0.0) result.hydrophobicity /= area;
    std::sort(result.residues.begin(), result.residues.end());
    result.residues.erase(std::unique(result.residues.begin(), result.residues.end()), result.residues.end());
    for (const std::uint32_t residue : result.residues) {
        const std::string_view name = parent_of(structure.residues[residue].name);
        result.charge +=
            static_cast<int>(name == "ARG" || name == "LYS") - static_cast<int>(name == "ASP" || name == "GLU");
    }
    return result;
}

std::vector<DescribedPocket> describe_pockets(const Pockets& pockets, const Structure& structure,
                                              std::span<const NamedPlace> places) {
    std::vector<DescribedPocket> result;
    for (const Pocket& pocket : pockets.pockets) {
        DescribedPocket described{.pocket = pocket, .chemistry = describe_pocket(pocket, structure)};
        if (!places.empty()) {
            const NamedPlace& place = places[result.size()];
            described.at = place.name;
            if (place.ligand.size() > 0)
                described.ligand = fit_ligand(structure.atoms, place.ligand, pocket, pockets.options.probe);
        }
        for (const std::uint32_t residue : described.chemistry.residues)
            if (std::string label = spaced_label(structure.residues[residue]); !label.empty())
                described.residues.push_back(std::move(label));
        result.push_back(std::move(described));
    }
    return result;
}

}  // namespace meniscus
