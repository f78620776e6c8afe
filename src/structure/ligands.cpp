// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/ligands.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "structure/gemmi/elements.h"

namespace meniscus {
namespace reading {
namespace {

constexpr double kTolerance = 0.4;  // Å: bonds of poor models and of metals count, contacts of 1,3 neighbours do not
constexpr double kShortest = 0.4;   // Å

using Bond = std::array<std::uint32_t, 2>;

std::vector<Bonding> bonding_of_atoms(const Ligands& ligands) {
    std::map<std::string, Bonding> known;
    std::vector<Bonding> all;
    all.reserve(ligands.labels.size());
    for (const AtomLabel& label : ligands.labels) {
        const auto [found, is_new] = known.try_emplace(label.element);
        if (is_new) found->second = bonding_of(label.element);
        all.push_back(found->second);
    }
    return all;
}

bool may_bond(const Bonding& a, const Bonding& b) {
    return !(a.is_metal && b.is_metal) && !(a.is_hydrogen && b.is_hydrogen);
}

std::vector<std::uint32_t> order_by_x(const std::vector<Vec3>& points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) { return points[a].x < points[b].x; });
    return order;
}

}  // namespace

std::vector<std::array<std::uint32_t, 2>> find_bonds(const Ligands& ligands) {
    const std::vector<Bonding> bonding = bonding_of_atoms(ligands);
    double widest = 0.0;
    for (const Bonding& atom : bonding) widest = std::max(widest, atom.radius);
    const std::vector<std::uint32_t> order = order_by_x(ligands.centres);
    std::vector<Bond> bonds;
    for (std::size_t i = 0; i < order.size(); ++i)
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const std::uint32_t a = order[i];
            const std::uint32_t b = order[j];
            const Vec3 apart = ligands.centres[b] - ligands.centres[a];
            if (apart.x > bonding[a].radius + widest + kTolerance) break;
            const double most = bonding[a].radius + bonding[b].radius + kTolerance;
            const double squared = squared_norm(apart);
            if (squared < most * most && squared > kShortest * kShortest && may_bond(bonding[a], bonding[b]))
                bonds.push_back({std::min(a, b), std::max(a, b)});
        }
    std::sort(bonds.begin(), bonds.end());
    return bonds;
}

Ligands part_of_ligands(const Ligands& ligands, const std::vector<bool>& wanted) {
    constexpr std::uint32_t kNone = ~0U;
    Ligands part;
    std::vector<std::uint32_t> residues(ligands.residues.size(), kNone);
    for (std::size_t r = 0; r < residues.size(); ++r) {
        if (!wanted[r]) continue;
        residues[r] = static_cast<std::uint32_t>(part.residues.size());
        part.residues.push_back(ligands.residues[r]);
    }
    std::vector<std::uint32_t> atoms(ligands.centres.size(), kNone);
    for (std::size_t a = 0; a < atoms.size(); ++a) {
        AtomLabel label = ligands.labels[a];
        if (residues[label.residue] == kNone) continue;
        atoms[a] = static_cast<std::uint32_t>(part.centres.size());
        label.residue = residues[label.residue];
        part.labels.push_back(std::move(label));
        part.centres.push_back(ligands.centres[a]);
    }
    for (const auto& [a, b] : ligands.bonds)
        if (atoms[a] != kNone && atoms[b] != kNone) part.bonds.push_back({atoms[a], atoms[b]});
    part.in_surface = ligands.in_surface && !part.centres.empty();
    return part;
}

Ligands ligands_of_chain(const Ligands& ligands, const std::string& chain) {
    std::vector<bool> wanted;
    for (const Residue& residue : ligands.residues) wanted.push_back(residue.chain == chain);
    return part_of_ligands(ligands, wanted);
}

}  // namespace reading

std::map<std::string, std::size_t> count_ligands(const Ligands& ligands) {
    std::map<std::string, std::size_t> counts;
    for (const Residue& residue : ligands.residues) ++counts[residue.name];
    return counts;
}

}  // namespace meniscus
