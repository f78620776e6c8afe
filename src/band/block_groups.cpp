// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/block_groups.h"

namespace meniscus {
namespace {

constexpr double kLargestGroup = 16.0;  // Å: blocks within this share one descent of the trees
constexpr int kLongestShift = 2;
constexpr int kPartShift = 1;
constexpr std::size_t kGroupsPerChunk = 16;  // to be sorted

BlockCoord coarser(const BlockCoord& c, int shift) { return {c.z >> shift, c.y >> shift, c.x >> shift}; }

int shift_of(double spacing) {
    int shift = 0;
    while (shift < kLongestShift && 2.0 * (kBlockEdge << shift) * spacing <= kLargestGroup) ++shift;
    return shift;
}

}  // namespace

BlockGroups::BlockGroups(const BlockGrid& grid) : grid_(grid), shift_(shift_of(grid.spacing())) {
    std::vector<BlockCoord> places;
    places.reserve(grid.block_count());
    for (const BlockCoord& c : grid.coords()) places.push_back(coarser(c, shift_));
    groups_ = group_by<BlockCoordHash>(places);
    parallel_for(size(), kGroupsPerChunk, [&](std::size_t g) {
        const auto first = groups_.items.begin();
        std::stable_sort(first + static_cast<std::ptrdiff_t>(groups_.begins[g]),
                         first + static_cast<std::ptrdiff_t>(groups_.begins[g + 1]),
                         [&](BlockId a, BlockId b) { return part(a) < part(b); });
    });
}

BlockCoord BlockGroups::part(BlockId b) const { return coarser(grid_.coord(b), std::max(0, shift_ - kPartShift)); }

Box BlockGroups::box_of(std::span<const BlockId> blocks) const {
    Box box;
    for (const BlockId b : blocks) box.include(box_of_nodes(grid_.corner(b), kBlockEdge, grid_.spacing()));
    return box;
}

}  // namespace meniscus
