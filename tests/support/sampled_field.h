// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Functions sampled on small block grids, for tests.
#pragma once

#include <cmath>
#include <utility>
#include <vector>

#include "grid/block_grid.h"

namespace meniscus::testing {

struct SampledField {
    BlockGrid grid;
    std::vector<float> values;
};

inline Vec3 node_position(const BlockGrid& grid, BlockId block, int x, int y, int z) {
    return grid.corner(block) + grid.spacing() * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
}

/// All blocks with coordinates from `low` to `high`, both included.
inline std::vector<BlockCoord> box_of_blocks(const BlockCoord& low, const BlockCoord& high) {
    std::vector<BlockCoord> blocks;
    for (std::int32_t z = low.z; z <= high.z; ++z)
        for (std::int32_t y = low.y; y <= high.y; ++y)
            for (std::int32_t x = low.x; x <= high.x; ++x) blocks.push_back({.z = z, .y = y, .x = x});
    return blocks;
}

/// Samples f(position) at every node of the grid.
template <class Function>
SampledField sample(BlockGrid grid, const Function& f) {
    std::vector<float> values;
    values.reserve(grid.node_count());
    for (BlockId b = 0; b < grid.block_count(); ++b)
        for (int z = 0; z < kBlockEdge; ++z)
            for (int y = 0; y < kBlockEdge; ++y)
                for (int x = 0; x < kBlockEdge; ++x)
                    values.push_back(static_cast<float>(f(node_position(grid, b, x, y, z))));
    return {.grid = std::move(grid), .values = std::move(values)};
}

/// Samples f(position) on the blocks that cover the box [low, high] with at least one spacing of margin. Node positions
/// are origin + multiples of the spacing.
template <class Function>
SampledField sample_box(double spacing, const Vec3& low, const Vec3& high, const Function& f, const Vec3& origin = {}) {
    const auto block_at = [&](const Vec3& p) {
        const double edge = kBlockEdge * spacing;
        return BlockCoord{.z = static_cast<std::int32_t>(std::floor((p.z - origin.z) / edge)),
                          .y = static_cast<std::int32_t>(std::floor((p.y - origin.y) / edge)),
                          .x = static_cast<std::int32_t>(std::floor((p.x - origin.x) / edge))};
    };
    const Vec3 margin{spacing, spacing, spacing};
    return sample(BlockGrid(spacing, origin, box_of_blocks(block_at(low - margin), block_at(high + margin))), f);
}

/// Keeps only the blocks with a node where |value| < half_width, and the blocks around them: a narrow band.
inline SampledField narrow_band(const SampledField& field, double half_width) {
    std::vector<bool> keep(field.grid.block_count(), false);
    for (std::size_t i = 0; i < field.values.size(); ++i)
        if (std::abs(field.values[i]) < half_width)
            for (const BlockId b : field.grid.neighbours(static_cast<BlockId>(i / kBlockNodes)))
                if (b != kNoBlock) keep[b] = true;
    std::vector<BlockCoord> blocks;
    std::vector<float> values;
    for (BlockId b = 0; b < keep.size(); ++b) {
        if (!keep[b]) continue;
        blocks.push_back(field.grid.coord(b));
        const auto first = field.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{b} * kBlockNodes);
        values.insert(values.end(), first, first + kBlockNodes);
    }
    return {.grid = BlockGrid(field.grid.spacing(), field.grid.origin(), std::move(blocks)),
            .values = std::move(values)};
}

}  // namespace meniscus::testing
