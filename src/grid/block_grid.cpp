// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_grid.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 1024;  // blocks per task: some tens of microseconds

// Finds the blocks around one block after the other. Those beside it in y and z follow each other just as the blocks
// do: one place for each of the nine rows goes along with them.
class NeighbourSearch {
public:
    // Begins at a block.
    NeighbourSearch(std::span<const BlockCoord> blocks, const BlockCoord& at) : blocks_(blocks) {
        for_each_row([&](std::size_t row, int dy, int dz) {
            places_[row] = std::lower_bound(blocks_.begin(), blocks_.end(), before_row(at, dy, dz));
        });
    }

    // Of the same block or a later one.
    void find(const BlockCoord& at, std::array<BlockId, 27>& around) {
        for_each_row([&](std::size_t row, int dy, int dz) {
            BlockCoord wanted = before_row(at, dy, dz);
            auto& place = places_[row];
            while (place != blocks_.end() && *place < wanted) ++place;
            auto next = place;
            for (std::size_t slot = 3 * row; slot < 3 * row + 3; ++slot, ++wanted.x) {
                const bool is_there = next != blocks_.end() && *next == wanted;
                around[slot] = is_there ? static_cast<BlockId>(next - blocks_.begin()) : kNoBlock;
                if (is_there) ++next;
            }
        });
    }

private:
    template <class Visit>
    static void for_each_row(const Visit& visit) {
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) visit(static_cast<std::size_t>(neighbour_slot(-1, dy, dz)) / 3, dy, dz);
    }
    static BlockCoord before_row(const BlockCoord& at, int dy, int dz) {
        return {.z = at.z + dz, .y = at.y + dy, .x = at.x - 1};
    }

    std::span<const BlockCoord> blocks_;
    std::array<std::span<const BlockCoord>::iterator, 9> places_;
};

}  // namespace

BlockGrid::BlockGrid(double spacing, const Vec3& origin, std::vector<BlockCoord> blocks)
    : spacing_(spacing), origin_(origin), blocks_(std::move(blocks)) {
    if (!std::is_sorted(blocks_.begin(), blocks_.end())) std::sort(blocks_.begin(), blocks_.end());
    slots_.assign(std::bit_ceil(2 * blocks_.size() + 1), kNoBlock);
    const std::size_t mask = slots_.size() - 1;
    for (BlockId b = 0; b < blocks_.size(); ++b) {
        std::size_t slot = BlockCoordHash{}(blocks_[b]) & mask;
        while (slots_[slot] != kNoBlock) slot = (slot + 1) & mask;
        slots_[slot] = b;
    }
    neighbours_.resize(blocks_.size());
    parallel_chunks(blocks_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        NeighbourSearch search(blocks_, blocks_[begin]);
        for (std::size_t b = begin; b < end; ++b) search.find(blocks_[b], neighbours_[b]);
    });
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
