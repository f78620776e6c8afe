// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/residue_kinds.h"

#include <algorithm>
#include <map>
#include <utility>

#include "radii/aliases.h"

namespace meniscus::reading {
namespace {

// Half again the lengths of the bonds, 1.33 Å and 1.6 Å: sloppy models count, contacts of atoms not bonded do not.
constexpr double kPeptideBond = 2.0;
constexpr double kPhosphodiesterBond = 2.4;

using AtomIndices = std::vector<std::uint32_t>;

bool is_within(const RawAtom& a, const RawAtom& b, double distance) {
    return squared_norm(a.centre - b.centre) < distance * distance;
}

// A bond from a polymer's main chain: its C to a nitrogen, its N to a carbon, its O3' to a P or back.
bool is_link(const RawAtom& polymer, const RawAtom& other) {
    if (polymer.name == "C") return other.element == "N" && is_within(polymer, other, kPeptideBond);
    if (polymer.name == "N") return other.element == "C" && is_within(polymer, other, kPeptideBond);
    const auto is_o3 = [](const RawAtom& a) { return a.name == "O3'" || a.name == "O3*"; };
    const bool phosphodiester = (is_o3(polymer) && other.name == "P") || (polymer.name == "P" && is_o3(other));
    return phosphodiester && is_within(polymer, other, kPhosphodiesterBond);
}

class Classifier {
public:
    explicit Classifier(RawModel& model) : model_(model), atoms_(model.residues.size()) {
        for (std::size_t i = 0; i < model.atoms.size(); ++i) {
            atoms_[model.atoms[i].residue].push_back(static_cast<std::uint32_t>(i));
        }
    }

    void run() {
        for (std::size_t i = 0; i < model_.residues.size(); ++i) first_guess(i);
        for (std::size_t i = 0; i < model_.residues.size(); ++i) {
            by_number_.emplace(std::pair(model_.residues[i].chain, model_.residues[i].number), i);
        }
        while (extend_polymers()) {
        }
    }

private:
    ResidueKind& kind(std::size_t i) { return model_.residues[i].kind; }

    bool is_hetero(std::size_t i) { return kind(i) == ResidueKind::Ligand || kind(i) == ResidueKind::Ion; }

    void first_guess(std::size_t i) {
        const auto in_atom_record = [&](std::uint32_t a) { return !model_.atoms[a].hetatm; };
        const RawResidue& residue = model_.residues[i];
        if (is_water(residue.name)) {
            kind(i) = ResidueKind::Water;
        } else if (residue.in_sequence || std::any_of(atoms_[i].begin(), atoms_[i].end(), in_atom_record)) {
            kind(i) = ResidueKind::Polymer;
        } else {
            kind(i) = is_single_atom(i) ? ResidueKind::Ion : ResidueKind::Ligand;
        }
    }

    // Alternatives of one atom are one atom.
    bool is_single_atom(std::size_t i) const {
        const std::string& name = model_.atoms[atoms_[i].front()].name;
        return std::all_of(atoms_[i].begin(), atoms_[i].end(), [&](std::uint32_t a) {
            return model_.atoms[a].name == name && (a == atoms_[i].front() || model_.atoms[a].altloc != ' ');
        });
    }

    bool extend_polymers() {
        bool changed = false;
        for (std::size_t i = 0; i < model_.residues.size(); ++i) {
            if (!is_hetero(i) || !has_polymer_neighbour(i)) continue;
            kind(i) = ResidueKind::Polymer;
            changed = true;
        }
        return changed;
    }

    bool has_polymer_neighbour(std::size_t i) {
        // Two residues away in the file, for alternatives with names of their own.
        const std::size_t first = i < 2 ? 0 : i - 2;
        for (std::size_t j = first; j < std::min(i + 3, model_.residues.size()); ++j) {
            if (is_linked_polymer(i, j)) return true;
        }
        for (const int number : {model_.residues[i].number - 1, model_.residues[i].number + 1}) {
            const auto [begin, end] = by_number_.equal_range({model_.residues[i].chain, number});
            if (std::any_of(begin, end, [&](const auto& entry) { return is_linked_polymer(i, entry.second); })) {
                return true;
            }
        }
        return false;
    }

    bool is_linked_polymer(std::size_t i, std::size_t j) {
        if (i == j || kind(j) != ResidueKind::Polymer || model_.residues[i].chain != model_.residues[j].chain) {
            return false;
        }
        return std::any_of(atoms_[j].begin(), atoms_[j].end(), [&](std::uint32_t a) {
            return std::any_of(atoms_[i].begin(), atoms_[i].end(),
                               [&](std::uint32_t b) { return is_link(model_.atoms[a], model_.atoms[b]); });
        });
    }

    RawModel& model_;
    std::vector<AtomIndices> atoms_;
    std::multimap<std::pair<std::string, int>, std::size_t> by_number_;
};

}  // namespace

void classify_residues(RawModel& model) { Classifier(model).run(); }

}  // namespace meniscus::reading
