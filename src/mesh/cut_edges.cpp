// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/cut_edges.h"

#include <array>
#include <cstring>
#include <utility>

#include "core/fresh_memory.h"
#include "core/parallel.h"
#include "core/sign_bits.h"

namespace meniscus {
namespace {

constexpr std::size_t kGrain = 32;  // blocks per task: some tens of microseconds

std::array<float, 4> four_of(const float* values) {
    std::array<float, 4> four;
    std::memcpy(four.data(), values, sizeof(four));
    return four;
}

InsideBits inside_bits_of_block(const float* values) {
    constexpr std::uint64_t kHalfRow = 0xF;
    InsideBits bits{};
    for (std::size_t z = 0; z < kBlockEdge; ++z)
        for (std::size_t y = 0; y < kBlockEdge; ++y, values += kBlockEdge) {
            const std::uint64_t row = negative_bits(four_of(values)) | negative_bits(four_of(values + 4)) << 4U;
            const std::size_t unit = 2 * (y / kUnitEdge) + 4 * (z / kUnitEdge);
            const std::size_t node = kUnitEdge * (y % kUnitEdge + kUnitEdge * (z % kUnitEdge));
            bits[unit] |= (row & kHalfRow) << node;
            bits[unit + 1] |= row >> kUnitEdge << node;
        }
    return bits;
}

// How much higher the last node of a unit along an axis is numbered than the first.
constexpr std::size_t last_along(std::size_t axis) { return std::size_t{kUnitEdge - 1} << (2 * axis); }

// Inside bits of the nodes after those of a unit along a direction.
UnitBits next_along(std::size_t direction, UnitBits unit, UnitBits beyond) {
    const std::size_t step = std::size_t{1} << (2 * direction);
    const std::size_t last = last_along(direction);
    const UnitBits first = kFirstNodes[direction];
    return (unit >> step & ~(first << last)) | (beyond & first) << last;
}

// The rows of a layer of a unit, every other half of the rows of a block.
constexpr std::uint64_t spread_rows(std::uint64_t layer) {
    layer = (layer | layer << 8U) & 0x00FF00FFU;
    return (layer | layer << 4U) & 0x0F0F0F0FU;
}

// Vertices are numbered layer by layer, cells are found unit by unit.
LayerBits layers_of(const InsideBits& units) {
    constexpr std::size_t kEdge = kUnitEdge;
    LayerBits layers;
    for (std::size_t z = 0; z < kBlockEdge; ++z) {
        const std::size_t first = z / kEdge * 4;
        const auto rows = [&](std::size_t unit) {
            return spread_rows(units[first + unit] >> (kEdge * kEdge * (z % kEdge)) & 0xFFFFU);
        };
        layers[z] = rows(0) | rows(1) << 4U | rows(2) << 32U | rows(3) << 36U;
    }
    return layers;
}

// Fills in the bits and ranks of a block and returns how many vertices it has.
std::size_t find_cut_edges(const BlockGrid& grid, std::span<const InsideBits> inside, std::size_t block,
                           CutEdges& edges) {
    const auto& around = grid.neighbours(static_cast<BlockId>(block));
    const InsideBits& bits = inside[block];
    std::size_t count = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        const BlockId beyond = upper_neighbour(around, std::size_t{1} << d);
        InsideBits cut;
        for (std::size_t unit = 0; unit < kUnits; ++unit) {
            const std::size_t next = unit ^ std::size_t{1} << d;
            if (next > unit)
                cut[unit] = bits[unit] ^ next_along(d, bits[unit], bits[next]);
            else if (beyond != kNoBlock)
                cut[unit] = bits[unit] ^ next_along(d, bits[unit], inside[beyond][next]);
            else
                cut[unit] = (bits[unit] ^ next_along(d, bits[unit], 0)) & ~(kFirstNodes[d] << last_along(d));
        }
        edges.bits[d] = layers_of(cut);
        for (std::size_t z = 0; z < kBlockEdge; ++z) {
            edges.rank[d][z] = static_cast<std::uint16_t>(count);
            count += count_bits(edges.bits[d][z]);
        }
    }
    return count;
}

}  // namespace

std::vector<InsideBits> inside_bits(const BlockGrid& grid, std::span<const float> values) {
    std::vector<InsideBits> inside(grid.block_count());
    parallel_for(inside.size(), kGrain,
                 [&](std::size_t b) { inside[b] = inside_bits_of_block(values.data() + b * kBlockNodes); });
    return inside;
}

UnitsAround units_around(const BlockGrid& grid, std::span<const InsideBits> inside, std::size_t block) {
    constexpr std::size_t kEdge = UnitsAround::kEdge;
    const auto& around = grid.neighbours(static_cast<BlockId>(block));
    UnitBits any = 0;
    UnitBits all = ~UnitBits{0};
    UnitsAround units;
    for (std::size_t octant = 0; octant < 8; ++octant) {
        const BlockId b = upper_neighbour(around, octant);
        units.exists[octant] = b != kNoBlock;
        if (b == kNoBlock) continue;
        for (std::size_t unit = 0; unit < kUnits; ++unit) {
            if ((unit & octant) != 0) continue;  // not next to the block
            const auto at = [&](std::size_t axis) { return (unit >> axis & 1U) + 2 * (octant >> axis & 1U); };
            const UnitBits word = inside[b][unit];
            units.inside[at(0) + kEdge * (at(1) + kEdge * at(2))] = word;
            any |= word;
            all &= word;
        }
    }
    units.mixed = any != 0 && ~all != 0;
    return units;
}

UnitCells cells_of(const UnitsAround& units, std::size_t unit) {
    constexpr std::size_t kEdge = UnitsAround::kEdge;
    constexpr std::array<std::size_t, 3> kSteps{1, kEdge, kEdge * kEdge};
    const std::size_t first = (unit & 1U) + kEdge * (unit >> 1U & 1U) + kEdge * kEdge * (unit >> 2U);
    UnitCells cells;
    for (std::size_t k = 0; k < 8; ++k)
        cells.corners[k] =
            units.inside[first + (k & 1U) * kSteps[0] + (k >> 1U & 1U) * kSteps[1] + (k >> 2U) * kSteps[2]];
    // First whole units, then axis by axis what lies one node further.
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t k = 0; k < 8; ++k)
            if (const std::size_t next = k | std::size_t{1} << axis; next != k)
                cells.corners[next] = next_along(axis, cells.corners[k], cells.corners[next]);
    UnitBits any = 0;
    UnitBits all = ~UnitBits{0};
    for (const UnitBits word : cells.corners) {
        any |= word;
        all &= word;
    }
    cells.cut = any & ~all;
    // Cells that reach into an octant do so along each of its axes.
    for (std::size_t octant = 1; octant < 8; ++octant) {
        if (units.exists[octant] || (octant & ~unit) != 0) continue;
        UnitBits reaching = ~UnitBits{0};
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((octant >> axis & 1U) != 0) reaching &= kFirstNodes[axis] << last_along(axis);
        cells.cut &= ~reaching;
    }
    return cells;
}

std::vector<CutEdges> find_cut_edges(const BlockGrid& grid, std::span<const InsideBits> inside) {
    std::vector<CutEdges> edges;
    resize_touched(edges, grid.block_count() + 1);
    parallel_for(grid.block_count(), kGrain, [&](std::size_t b) {
        edges[b].first_vertex = find_cut_edges(grid, inside, b, edges[b]);  // counts for now
    });
    std::size_t vertices = 0;
    for (CutEdges& e : edges) vertices += std::exchange(e.first_vertex, vertices);
    return edges;
}

}  // namespace meniscus
