// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>
#include <vector>

#include "meniscus/write.h"

namespace meniscus {
namespace {

// The last letter that names no chain, or what fpocket always has.
std::string chain_of_points(const Structure& structure) {
    for (char letter = 'Z'; letter >= 'A'; --letter)
        if (std::none_of(structure.residues.begin(), structure.residues.end(),
                         [&](const Residue& residue) { return residue.chain == std::string(1, letter); }))
            return {letter};
    return "C";
}

std::vector<double> ranks_of_atoms(const Structure& structure, const Pockets& pockets) {
    std::vector<double> ranks(structure.atoms.size());
    std::vector<double> areas(structure.atoms.size());
    for (const Pocket& pocket : pockets.pockets)
        for (const WallAtom& wall : pocket.wall) {
            if (wall.area <= areas[wall.atom]) continue;
            areas[wall.atom] = wall.area;
            ranks[wall.atom] = static_cast<double>(pocket.rank);
        }
    return ranks;
}

}  // namespace

void write_pocket_atoms(const std::string& path, const Structure& structure, const Pockets& pockets) {
    constexpr float kMostOfCube = 0.5F;
    std::vector<double> ranks = ranks_of_atoms(structure, pockets);
    Structure with_points = structure;
    const std::string chain = chain_of_points(structure);
    for (const Pocket& pocket : pockets.pockets) {
        const auto residue = static_cast<std::uint32_t>(with_points.residues.size());
        with_points.residues.push_back({chain, "STP", static_cast<int>(pocket.rank), ' '});
        for (const std::uint32_t v : pocket.voxels) {
            const PocketVoxel& voxel = pockets.voxels[v];
            if (voxel.share < kMostOfCube) continue;
            AtomLabel label;
            label.residue = residue;
            label.name = "APOL";
            with_points.labels.push_back(label);
            with_points.atoms.centres.push_back(voxel.position);
            with_points.atoms.radii.push_back(1.0);
            ranks.push_back(static_cast<double>(pocket.rank));
        }
    }
    write_structure_copy(path, with_points, ranks);
}

}  // namespace meniscus
