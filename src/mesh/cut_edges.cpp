// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/cut_edges.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include <utility>

#include "core/count_bits.h"
#include "core/fresh_memory.h"
#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kGrain = 32;  // blocks per task: some tens of microseconds

// Eight values -> eight bits.
std::uint64_t negative_bits(const float* values) {
#ifdef __SSE2__
    const auto of_four = [](const float* at) {
        return static_cast<unsigned>(_mm_movemask_ps(_mm_cmplt_ps(_mm_loadu_ps(at), _mm_setzero_ps())));
    };
    return of_four(values) | of_four(values + 4) << 4U;
#else
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < kBlockEdge; ++i) bits |= std::uint64_t{values[i] < 0.0F} << i;
    return bits;
#endif
}

NodeBits inside_bits_of_block(const float* values) {
    NodeBits bits{};
    for (std::size_t z = 0; z < kBlockEdge; ++z)
        for (std::size_t y = 0; y < kBlockEdge; ++y, values += kBlockEdge)
            bits[z] |= negative_bits(values) << (kBlockEdge * y);
    return bits;
}

// Where the nodes of an octant's block begin among the rows, and how many of them lie next to the block.
struct Strip {
    explicit constexpr Strip(std::size_t octant)
        : x0((octant & 1U) * kBlockEdge), y0((octant >> 1U & 1U) * kBlockEdge), z0((octant >> 2U) * kBlockEdge) {}
    std::size_t x0, y0, z0;
    std::size_t ys = y0 > 0 ? 1 : kBlockEdge;
    std::size_t zs = z0 > 0 ? 1 : kBlockEdge;
    std::uint64_t keep = x0 > 0 ? 1U : 0xFFU;
};

void copy_rows(const NodeBits& bits, const Strip& strip, Rows& rows) {
    for (std::size_t z = 0; z < strip.zs; ++z)
        for (std::size_t y = 0; y < strip.ys; ++y)
            rows.inside[strip.y0 + y + kRowNodes * (strip.z0 + z)] |=
                static_cast<std::uint16_t>((bits[z] >> (kBlockEdge * y) & strip.keep) << strip.x0);
}

// Cells whose eight nodes exist, in the rows of one class (see Rows::complete).
std::uint8_t complete_cells(const std::array<bool, 8>& exists, std::size_t row_class) {
    bool inner = true;
    bool last = true;
    for (std::size_t octant = 0; octant < 8; ++octant) {
        if ((octant & ~(2 * row_class + 1)) != 0) continue;
        last = last && exists[octant];
        if ((octant & 1U) == 0) inner = inner && exists[octant];
    }
    return static_cast<std::uint8_t>((inner ? 0x7FU : 0U) | (last ? 0x80U : 0U));
}

// Inside bits of the nodes after those of a block along a direction, and which of these nodes there are.
struct NextNodes {
    NodeBits inside;
    NodeBits exist;
};
NextNodes next_along(std::size_t direction, const NodeBits& block, const NodeBits* beyond) {
    static_assert(kBlockEdge == 8);
    constexpr std::uint64_t kFirstColumn = 0x0101010101010101U;
    constexpr std::uint64_t kFirstRow = 0xFF;
    const NodeBits other = beyond != nullptr ? *beyond : NodeBits{};
    const std::uint64_t last = beyond != nullptr ? ~std::uint64_t{0} : 0;  // whether the last nodes have one after them
    NextNodes next;
    for (std::size_t z = 0; z < kBlockEdge; ++z) {
        if (direction == 0) {
            next.inside[z] = (block[z] >> 1U & ~(kFirstColumn << 7U)) | (other[z] & kFirstColumn) << 7U;
            next.exist[z] = ~(kFirstColumn << 7U) | last;
        } else if (direction == 1) {
            next.inside[z] = block[z] >> 8U | (other[z] & kFirstRow) << 56U;
            next.exist[z] = ~(kFirstRow << 56U) | last;
        } else {
            next.inside[z] = z + 1 < kBlockEdge ? block[z + 1] : other[0];
            next.exist[z] = z + 1 < kBlockEdge ? ~std::uint64_t{0} : last;
        }
    }
    return next;
}

// Fills in the bits and ranks of a block and returns how many vertices it has.
std::size_t find_cut_edges(const BlockGrid& grid, std::span<const NodeBits> inside, std::size_t block,
                           CutEdges& edges) {
    std::size_t count = 0;
    for (std::size_t d = 0; d < 3; ++d) {
        const BlockId beyond = upper_neighbour(grid.neighbours(static_cast<BlockId>(block)), std::size_t{1} << d);
        const NextNodes next = next_along(d, inside[block], beyond != kNoBlock ? &inside[beyond] : nullptr);
        for (std::size_t z = 0; z < kBlockEdge; ++z) {
            edges.bits[d][z] = (inside[block][z] ^ next.inside[z]) & next.exist[z];
            edges.rank[d][z] = static_cast<std::uint16_t>(count);
            count += count_bits(edges.bits[d][z]);
        }
    }
    return count;
}

}  // namespace

std::vector<NodeBits> inside_bits(const BlockGrid& grid, std::span<const float> values) {
    std::vector<NodeBits> inside(grid.block_count());
    parallel_for(inside.size(), kGrain,
                 [&](std::size_t b) { inside[b] = inside_bits_of_block(values.data() + b * kBlockNodes); });
    return inside;
}

Rows rows_of(const BlockGrid& grid, std::span<const NodeBits> inside, std::size_t block) {
    const auto& around = grid.neighbours(static_cast<BlockId>(block));
    std::uint64_t any = 0;
    std::uint64_t all = ~std::uint64_t{0};
    Rows rows;
    for (std::size_t octant = 0; octant < 8; ++octant) {
        const BlockId b = upper_neighbour(around, octant);
        rows.exists[octant] = b != kNoBlock;
        if (b == kNoBlock) continue;
        for (const std::uint64_t word : inside[b]) {
            any |= word;
            all &= word;
        }
    }
    rows.mixed = any != 0 && ~all != 0;
    if (!rows.mixed) return rows;
    for (std::size_t octant = 0; octant < 8; ++octant)
        if (rows.exists[octant]) copy_rows(inside[upper_neighbour(around, octant)], Strip(octant), rows);
    for (std::size_t c = 0; c < rows.complete.size(); ++c) rows.complete[c] = complete_cells(rows.exists, c);
    return rows;
}

std::vector<CutEdges> find_cut_edges(const BlockGrid& grid, std::span<const NodeBits> inside) {
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
