// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The voxels around a voxel.
#pragma once

#include <cstdlib>

#include "pockets/pocket_space.h"

namespace meniscus {

/// Calls visit(voxel, number of axes along which it is beside) for the up to 26 voxels around one.
template <class Visit>
void for_each_voxel_around(const PocketSpace& space, VoxelId voxel, const Visit& visit) {
    const BlockId block = space.nodes[voxel] / kBlockNodes;
    const int node = static_cast<int>(space.nodes[voxel] % kBlockNodes);
    const int x = node % kBlockEdge;
    const int y = node / kBlockEdge % kBlockEdge;
    const int z = node / (kBlockEdge * kBlockEdge);
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) {
                const int axes = std::abs(dx) + std::abs(dy) + std::abs(dz);
                if (axes == 0) continue;
                const VoxelId other = space.voxel_near(block, x + dx, y + dy, z + dz);
                if (other != kNoVoxel) visit(other, axes);
            }
}

/// Calls visit(voxel) for all of them.
template <class Visit>
void for_each_neighbour(const PocketSpace& space, VoxelId voxel, const Visit& visit) {
    for_each_voxel_around(space, voxel, [&](VoxelId other, int) { visit(other); });
}

/// Calls visit(voxel) for those whose cubes share a face with this one's.
template <class Visit>
void for_each_face_neighbour(const PocketSpace& space, VoxelId voxel, const Visit& visit) {
    for_each_voxel_around(space, voxel, [&](VoxelId other, int axes) {
        if (axes == 1) visit(other);
    });
}

}  // namespace meniscus
