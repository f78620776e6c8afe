// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which blocks of the grid the narrow band around the surface touches.
#pragma once

#include <cstddef>
#include <vector>

#include "geometry/accessible_surface.h"
#include "grid/block_grid.h"

namespace meniscus {

/// Where the nodes of a grid are.
struct Lattice {
    double spacing = 0.5;  ///< Å
    Vec3 origin;           ///< of node (0, 0, 0) of block (0, 0, 0)

    double block_edge() const { return kBlockEdge * spacing; }
    Vec3 corner(const BlockCoord& block) const {
        return origin + Vec3{block_edge() * block.x, block_edge() * block.y, block_edge() * block.z};
    }
    Vec3 centre(const BlockCoord& block) const { return corner(block) + 0.5 * block_edge() * Vec3{1.0, 1.0, 1.0}; }
    /// The block that contains a point. throws LimitError where its coordinates would not fit in 32 bits
    BlockCoord block_of(const Vec3& point) const;
};

/// Every block that may hold a point with |signed distance| < margin, ascending.
///
/// The signed distance changes by at most 1 per Å, so a block is out as soon as its centre is farther than
/// margin plus half a diagonal; the others are found by spreading from points of the surface.
/// throws   LimitError when more than max_blocks are found
/// cost     O(blocks · log atoms)
std::vector<BlockCoord> blocks_near_surface(const AccessibleSurface& surface, const Lattice& lattice, double margin,
                                            std::size_t max_blocks);

}  // namespace meniscus
