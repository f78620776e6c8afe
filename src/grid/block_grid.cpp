// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_grid.h"

#include <algorithm>
#include <array>
#include <bit>

#include "core/parallel.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 1024;  // blocks per task: some tens of microseconds

// Finds the blocks around one block after the other. Those beside it in y and z follow each other just as the blocks
// do: one place for each of the nine rows goes along with them.
class NeighbourSearch {
public:
    // `around` has room for what is found of each block.
    NeighbourSearch(std::span<const BlockCoord> blocks, std::span<std::array<BlockId, 27>> around)
        : blocks_(blocks), around_(around) {}

    // Finds what is around the blocks from `begin` to `end`.
    void find(std::size_t begin, std::size_t end) {
        for_each_row([&](std::size_t row, int dy, int dz) {
            const auto place = std::lower_bound(blocks_.begin(), blocks_.end(), beside(blocks_[begin], -1, dy, dz));
            places_[row] = static_cast<BlockId>(place - blocks_.begin());
        });
        begin_anew(begin);
        for (std::size_t b = begin + 1; b < end; ++b) {
            if (blocks_[b] == beside(blocks_[b - 1], 1, 0, 0))
                go_on(b);
            else
                begin_anew(b);
        }
    }

private:
    template <class Visit>
    static void for_each_row(const Visit& visit) {
        for (int dz = -1; dz <= 1; ++dz)
            for (int dy = -1; dy <= 1; ++dy) visit(static_cast<std::size_t>(neighbour_slot(-1, dy, dz)) / 3, dy, dz);
    }
    static BlockCoord beside(const BlockCoord& at, int dx, int dy, int dz) {
        return {.z = at.z + dz, .y = at.y + dy, .x = at.x + dx};
    }

    // Two thirds of what is around a block is around the next one in its row.
    void go_on(std::size_t block) {
        const BlockCoord at = blocks_[block];
        const std::array<BlockId, 27>& before = around_[block - 1];
        std::array<BlockId, 27>& around = around_[block];
        for_each_row([&](std::size_t row, int dy, int dz) {
            around[3 * row] = before[3 * row + 1];
            around[3 * row + 1] = before[3 * row + 2];
            around[3 * row + 2] = take(places_[row], beside(at, 1, dy, dz));
        });
    }

    void begin_anew(std::size_t block) {
        const BlockCoord at = blocks_[block];
        std::array<BlockId, 27>& around = around_[block];
        for_each_row([&](std::size_t row, int dy, int dz) {
            const BlockCoord first = beside(at, -1, dy, dz);
            BlockId& place = places_[row];
            while (place < blocks_.size() && blocks_[place] < first) ++place;
            while (place > 0 && !(blocks_[place - 1] < first)) --place;  // after a gap of one block
            for (int dx = -1; dx <= 1; ++dx)
                around[3 * row + static_cast<std::size_t>(dx + 1)] = take(place, beside(at, dx, dy, dz));
        });
    }

    // The block at a place, which moves on, if it is the one wanted. Where a surface's blocks end nobody foresees:
    // there is no branch but at the end of the list.
    BlockId take(BlockId& place, const BlockCoord& wanted) const {
        if (place >= blocks_.size()) return kNoBlock;
        const BlockCoord& at = blocks_[place];
        const auto is_there = static_cast<BlockId>(((at.x ^ wanted.x) | (at.y ^ wanted.y) | (at.z ^ wanted.z)) == 0);
        const BlockId found = place | (is_there - 1);  // kNoBlock has all bits
        place += is_there;
        return found;
    }

    std::span<const BlockCoord> blocks_;
    std::span<std::array<BlockId, 27>> around_;
    std::array<BlockId, 9> places_{};  // by row, of the first block after those around the block before
};

}  // namespace

BlockGrid::BlockGrid(double spacing, const Vec3& origin, std::vector<BlockCoord> blocks)
    : spacing_(spacing), origin_(origin), blocks_(std::move(blocks)) {
    if (!std::is_sorted(blocks_.begin(), blocks_.end())) std::sort(blocks_.begin(), blocks_.end());
    parallel_both([&] { fill_slots(); },
                  [&] {
                      resize_touched(neighbours_, blocks_.size());
                      parallel_chunks(blocks_.size(), kChunk, [&](std::size_t begin, std::size_t end) {
                          NeighbourSearch(blocks_, neighbours_).find(begin, end);
                      });
                  });
}

void BlockGrid::fill_slots() {
    slots_.assign(std::bit_ceil(2 * blocks_.size() + 1), kNoBlock);
    const std::size_t mask = slots_.size() - 1;
    for (BlockId b = 0; b < blocks_.size(); ++b) {
        std::size_t slot = BlockCoordHash{}(blocks_[b]) & mask;
        while (slots_[slot] != kNoBlock) slot = (slot + 1) & mask;
        slots_[slot] = b;
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
