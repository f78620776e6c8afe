// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_grid.h"

#include <algorithm>
#include <bit>

namespace meniscus {
BlockGrid::BlockGrid(double spacing, const Vec3& origin, std::vector<BlockCoord> blocks)
    : spacing_(spacing), origin_(origin), blocks_(std::move(blocks)) {
    std::sort(blocks_.begin(), blocks_.end());
    slots_.assign(std::bit_ceil(2 * blocks_.size() + 1), kNoBlock);
    const std::size_t mask = slots_.size() - 1;
    for (BlockId b = 0; b < blocks_.size(); ++b) {
        std::size_t slot = BlockCoordHash{}(blocks_[b]) & mask;
        while (slots_[slot] != kNoBlock) slot = (slot + 1) & mask;
        slots_[slot] = b;
    }
    neighbours_.resize(blocks_.size());
    for (BlockId b = 0; b < blocks_.size(); ++b) {
        const BlockCoord& c = blocks_[b];
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy)
                for (int dx = -1; dx <= 1; ++dx)
                    neighbours_[b][static_cast<std::size_t>(neighbour_slot(dx, dy, dz))] =
                        find({.z = c.z + dz, .y = c.y + dy, .x = c.x + dx});
    }
}

BlockId BlockGrid::find(const BlockCoord& coord) const {
    const std::size_t mask = slots_.size() - 1;
    for (std::size_t slot = BlockCoordHash{}(coord)&mask; slots_[slot] != kNoBlock; slot = (slot + 1) & mask)
        if (blocks_[slots_[slot]] == coord) return slots_[slot];
    return kNoBlock;
}

Vec3 BlockGrid::corner(const BlockCoord& coord) const {
    const double edge = kBlockEdge * spacing_;
    return origin_ + Vec3{edge * coord.x, edge * coord.y, edge * coord.z};
}

}  // namespace meniscus
