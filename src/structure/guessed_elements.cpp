// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/guessed_elements.h"

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "radii/aliases.h"
#include "reading/lower_case.h"
#include "reading/text.h"
#include "structure/element.h"

namespace meniscus::reading {
namespace {

bool is_certain(const std::string& residue) {
    // UNK is any small molecule to some programs.
    return (is_amino_acid(residue) && residue != "UNK") || is_nucleotide(residue) || is_water(residue);
}

std::string symbol(const std::string& element) {
    return element.empty() ? "unknown" : element.substr(0, 1) + lower_case(element.substr(1));
}

// "14 C, 2 Cl, 1 Br": the most frequent first.
std::string listed(const std::map<std::string, std::size_t>& counts) {
    std::vector<std::pair<std::string, std::size_t>> sorted(counts.begin(), counts.end());
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string text;
    for (const auto& [element, count] : sorted)
        text += (text.empty() ? "" : ", ") + std::to_string(count) + " " + symbol(element);
    return text;
}

}  // namespace

void correct_lone_ions(RawModel& model) {
    std::vector<std::uint32_t> atoms(model.residues.size());
    for (const RawAtom& atom : model.atoms) ++atoms[atom.residue];
    for (RawAtom& atom : model.atoms) {
        if (!atom.guessed_element || atoms[atom.residue] > 1) continue;
        std::string ion = element_of_ion(atom.name, model.residue_of(atom).name);
        if (!ion.empty()) atom.element = std::move(ion);
    }
}

void tell_guessed_elements(const RawModel& model, const std::string& missing, Chosen& chosen) {
    std::size_t certain = 0;
    std::size_t doubtful = 0;
    std::map<std::string, std::size_t> guessed;
    for (const std::uint32_t i : chosen.atoms) {
        const RawAtom& atom = model.atoms[i];
        if (!atom.guessed_element) continue;
        const bool is_doubtful = !is_certain(model.residue_of(atom).name);
        ++(is_doubtful ? doubtful : certain);
        if (is_doubtful) ++guessed[atom.element];
    }
    if (certain > 0) chosen.notes.push_back(counted(certain, "element") + " taken from atom names: " + missing);
    if (doubtful > 0)
        chosen.warnings.push_back(counted(doubtful, "element") + " in non-standard residues guessed from atom names: " +
                                  listed(guessed) + " (" + missing + ")");
}

}  // namespace meniscus::reading
