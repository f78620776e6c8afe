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

void write_pocket_atoms(const std::string& path, const Structure& structure, const Pockets& pockets,
                        const PathsOfPockets& paths) {
    constexpr float kMostOfCube = 0.5F;
    std::vector<double> values = ranks_of_atoms(structure, pockets);
    Structure with_points = structure;
    const std::string chain = chain_of_points(structure);
    const auto add_residue = [&](const char* name, std::size_t number) {
        with_points.residues.push_back({chain, name, static_cast<int>(number), ' '});
    };
    const auto add_point = [&](const char* name, const Vec3& position, double value) {
        AtomLabel label;
        label.residue = static_cast<std::uint32_t>(with_points.residues.size() - 1);
        label.name = name;
        with_points.labels.push_back(label);
        with_points.atoms.centres.push_back(position);
        with_points.atoms.radii.push_back(1.0);
        values.push_back(value);
    };
    for (const Pocket& pocket : pockets.pockets) {
        add_residue("STP", pocket.rank);
        for (const std::uint32_t v : pocket.voxels) {
            const PocketVoxel& voxel = pockets.voxels[v];
            if (voxel.share >= kMostOfCube) add_point("APOL", voxel.position, static_cast<double>(pocket.rank));
        }
    }
    const auto add_path = [&](const char* residue, std::size_t number, const TunnelPath& way) {
        add_residue(residue, number);
        for (const PathPoint& point : way.points) add_point("PATH", point.position, point.radius);
    };
    for (std::size_t i = 0; i < paths.tunnels.size(); ++i) add_path("TUN", i + 1, paths.tunnels[i]);
    if (paths.pore) add_path("POR", 1, *paths.pore);
    write_structure_copy(path, with_points, values);
}

}  // namespace meniscus
