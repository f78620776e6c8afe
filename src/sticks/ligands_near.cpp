// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <cmath>
#include <map>

#include "meniscus/ligand_bodies.h"
#include "structure/ligands.h"

namespace meniscus {
namespace {

constexpr double kNear = 6.0;  // Å: no water lies between

using Cell = std::array<std::int64_t, 3>;

Cell cell_of(const Vec3& point) {
    return {std::llround(point.x / kNear), std::llround(point.y / kNear), std::llround(point.z / kNear)};
}

/// The atoms in every cell and in those around it.
std::map<Cell, std::vector<std::uint32_t>> atoms_by_cell(const std::vector<Vec3>& centres) {
    std::map<Cell, std::vector<std::uint32_t>> cells;
    for (std::uint32_t atom = 0; atom < centres.size(); ++atom) {
        const auto [x, y, z] = cell_of(centres[atom]);
        for (const int i : {-1, 0, 1})
            for (const int j : {-1, 0, 1})
                for (const int k : {-1, 0, 1}) cells[{x + i, y + j, z + k}].push_back(atom);
    }
    return cells;
}

}  // namespace

Ligands ligands_near(const Ligands& ligands, const Mesh& mesh) {
    if (ligands.centres.empty()) return {};
    const auto cells = atoms_by_cell(ligands.centres);
    std::vector<bool> wanted(ligands.residues.size());
    for (const Vec3& vertex : mesh.vertices) {
        const auto found = cells.find(cell_of(vertex));
        if (found == cells.end()) continue;
        for (const std::uint32_t atom : found->second) {
            const std::uint32_t residue = ligands.labels[atom].residue;
            if (!wanted[residue] && squared_norm(ligands.centres[atom] - vertex) <= kNear * kNear)
                wanted[residue] = true;
        }
    }
    return reading::part_of_ligands(ligands, wanted);
}

}  // namespace meniscus
