// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The space between two probes' surfaces on a grid: which cubes of the grid lie in it, and how much of each.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/accessible_surface.h"
#include "grid/block_grid.h"

namespace meniscus {

/// Number of a voxel of a PocketSpace, from 0.
using VoxelId = std::uint32_t;
inline constexpr VoxelId kNoVoxel = 0xffffffffU;

/// Voxels are nodes of the grid whose cubes are at least partly in pocket space. Arrays have one entry per voxel.
struct PocketSpace {
    BlockGrid grid;                    ///< of blocks that hold voxels, or are next to those
    std::vector<VoxelId> voxel_of;     ///< per node
    std::vector<std::uint32_t> nodes;  ///< of the grid, ascending
    std::vector<double> inner;         ///< signed distance to the SES of the small probe, Å
    std::vector<double> outer;         ///< signed distance to the SES of the large probe, Å
    std::vector<double> shares;        ///< parts of the cubes that lie in pocket space, 0 to 1

    std::size_t size() const { return nodes.size(); }
    Vec3 position(VoxelId voxel) const { return grid.position(nodes[voxel]); }
    /// Whether the node itself, not only a part of its cube, lies in pocket space.
    bool is_within(VoxelId voxel) const { return inner[voxel] > 0.0 && outer[voxel] < 0.0; }
    /// The voxel at a node of a block, whose coordinates may be one beyond the block, or kNoVoxel.
    VoxelId voxel_near(BlockId block, int x, int y, int z) const;
    /// The voxel whose cube holds a point, or kNoVoxel.
    VoxelId voxel_at(const Vec3& point) const;
};

/// Signed distances of both surfaces where they differ. The grid's nodes are at multiples of the spacing from the
/// lower corner of the centres' bounding box, 3 Å less and rounded down.
///
/// throws   LimitError for more voxels than numbers
PocketSpace pocket_space(const AccessibleSurface& small, const AccessibleSurface& large, std::span<const Vec3> centres,
                         double spacing);

}  // namespace meniscus
