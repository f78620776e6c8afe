// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/cut_edges.h"

#include <array>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/parallel.h"
#include "mesh/cell_cases.h"
#include "platform/fresh_memory.h"
#include "simd/sign_bits.h"

namespace meniscus {
namespace {

constexpr std::size_t kGrain = 32;  // blocks per task: some tens of microseconds

constexpr std::uint64_t kLastColumn = kFirstColumn << (kBlockEdge - 1);
constexpr std::uint64_t kLastRow = kFirstRow << (kBlockEdge * (kBlockEdge - 1));

using WordPair = std::uint64_t __attribute__((vector_size(16)));  // of two layers

// Exchanges the bits `lower` of b with those of a that are numbered higher by a distance.
void exchange(WordPair& a, WordPair& b, int distance, std::uint64_t lower) {
    const WordPair differ = (a >> distance ^ b) & lower;
    b ^= differ;
    a ^= differ << distance;
}

std::array<float, 4> four_of(const float* values) {
    std::array<float, 4> four;
    std::memcpy(four.data(), values, sizeof(four));
    return four;
}

LayerBits layers_of_block(const float* values) {
    LayerBits layers{};
    for (std::uint64_t& layer : layers)
        for (std::size_t y = 0; y < kBlockEdge; ++y, values += kBlockEdge)
            layer |= (negative_bits(four_of(values)) | negative_bits(four_of(values + 4)) << 4U) << (kBlockEdge * y);
    return layers;
}

// Every other half of the rows of a block: those of a layer of two units, one beyond the other along y.
constexpr std::uint64_t half_rows(UnitBits near, UnitBits far, std::size_t z) {
    constexpr std::size_t kLayer = std::size_t{kUnitEdge} * kUnitEdge;
    std::uint64_t rows = (near >> (kLayer * z) & 0xFFFFU) | (far >> (kLayer * z) & 0xFFFFU) << 32U;
    rows = (rows | rows << 8U) & 0x00FF00FF00FF00FFU;
    return (rows | rows << 4U) & 0x0F0F0F0F0F0F0F0FU;
}

LayerBits layers_of_block(const InsideBits& units) {
    LayerBits layers;
    for (std::size_t z = 0; z < kBlockEdge; ++z) {
        const UnitBits* const unit = units.data() + z / kUnitEdge * 4;
        const std::uint64_t left = half_rows(unit[0], unit[2], z % kUnitEdge);
        const std::uint64_t right = half_rows(unit[1], unit[3], z % kUnitEdge);
        layers[z] = left | right << kUnitEdge;
    }
    return layers;
}

// A layer of nodes, with those next to it along x, y and both, as in NodesAround.
std::array<std::uint64_t, 4> shifted_layers(std::uint64_t own, std::uint64_t x, std::uint64_t y, std::uint64_t xy) {
    constexpr std::size_t kLast = kBlockEdge - 1;
    const std::uint64_t next = (own & ~kFirstColumn) >> 1U | (x & kFirstColumn) << kLast;
    const std::uint64_t next_of_y = (y & (kFirstRow - 1)) >> 1U | (xy & 1U) << kLast;
    return {own, next, own >> kBlockEdge | y << (kBlockEdge * kLast),
            next >> kBlockEdge | next_of_y << (kBlockEdge * kLast)};
}

LayerBits whole_cells(const std::array<bool, 8>& exists) {
    LayerBits whole;
    whole.fill(~std::uint64_t{0});
    // Cells that reach into an octant do so along each of its axes.
    for (std::size_t octant = 1; octant < 8; ++octant) {
        if (exists[octant]) continue;
        std::uint64_t reaching = ~std::uint64_t{0};
        if ((octant & 1U) != 0) reaching &= kLastColumn;
        if ((octant & 2U) != 0) reaching &= kLastRow;
        for (std::size_t z = (octant & 4U) != 0 ? kBlockEdge - 1 : 0; z < kBlockEdge; ++z) whole[z] &= ~reaching;
    }
    return whole;
}

// Fills in the bits and ranks of a block and returns how many vertices it has.
std::size_t find_cut_edges(const NodesAround& nodes, CutEdges& edges) {
    const std::uint64_t with_x = nodes.exists[1] ? ~std::uint64_t{0} : ~kLastColumn;
    const std::uint64_t with_y = nodes.exists[2] ? ~std::uint64_t{0} : ~kLastRow;
    for (std::size_t z = 0; z < kBlockEdge; ++z) {
        const std::uint64_t own = nodes.inside[0][z];
        edges.bits[0][z] = (own ^ nodes.inside[1][z]) & with_x;
        edges.bits[1][z] = (own ^ nodes.inside[2][z]) & with_y;
        edges.bits[2][z] = own ^ nodes.inside[0][z + 1];
    }
    if (!nodes.exists[4]) edges.bits[2].back() = 0;
    std::size_t count = 0;
    for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t z = 0; z < kBlockEdge; ++z) {
            edges.rank[d][z] = static_cast<std::uint16_t>(count);
            count += count_bits(edges.bits[d][z]);
        }
    return count;
}

}  // namespace

NodesAround nodes_around(const BlockGrid& grid, std::span<const LayerBits> inside, std::size_t block) {
    static constexpr LayerBits kMissing{};
    const auto& around = grid.neighbours(static_cast<BlockId>(block));
    NodesAround nodes;
    std::array<const LayerBits*, 8> layers;
    for (std::size_t octant = 0; octant < 8; ++octant) {
        const BlockId b = upper_neighbour(around, octant);
        nodes.exists[octant] = b != kNoBlock;
        layers[octant] = b != kNoBlock ? &inside[b] : &kMissing;
    }
    const auto enter = [&](std::size_t z, std::size_t first, std::size_t layer) {
        const auto word = [&](std::size_t octant) { return (*layers[first + octant])[layer]; };
        const auto shifted = shifted_layers(word(0), word(1), word(2), word(3));
        for (std::size_t k = 0; k < shifted.size(); ++k) nodes.inside[k][z] = shifted[k];
    };
    for (std::size_t z = 0; z < kBlockEdge; ++z) enter(z, 0, z);
    enter(kBlockEdge, 4, 0);
    nodes.whole = whole_cells(nodes.exists);
    return nodes;
}

LayerBits cut_cells(const NodesAround& nodes) {
    std::array<std::uint64_t, kRowNodes> any;
    std::array<std::uint64_t, kRowNodes> all;
    for (std::size_t z = 0; z < kRowNodes; ++z) {
        any[z] = nodes.inside[0][z] | nodes.inside[1][z] | nodes.inside[2][z] | nodes.inside[3][z];
        all[z] = nodes.inside[0][z] & nodes.inside[1][z] & nodes.inside[2][z] & nodes.inside[3][z];
    }
    LayerBits cut;
    for (std::size_t z = 0; z < kBlockEdge; ++z)
        cut[z] = (any[z] | any[z + 1]) & ~(all[z] & all[z + 1]) & nodes.whole[z];
    return cut;
}

CellCases::CellCases(const NodesAround& nodes) {
    for (std::size_t z = 0; z < kBlockEdge; z += 2) {
        std::array<WordPair, kCellCorners> words;
        for (std::size_t k = 0; k < words.size(); ++k)
            std::memcpy(&words[k], &nodes.inside[k % 4][z + k / 4], sizeof(WordPair));
        // A word for each corner with a bit for each cell becomes one for each place along x with a byte for each row
        // and a bit for each corner: digit by digit, corners change places with x.
        for (std::size_t k = 0; k < 4; ++k) exchange(words[k], words[k + 4], 4, 0x0F0F0F0F0F0F0F0FU);
        for (const std::size_t k : {0, 1, 4, 5}) exchange(words[k], words[k + 2], 2, 0x3333333333333333U);
        for (std::size_t k = 0; k < words.size(); k += 2) exchange(words[k], words[k + 1], 1, 0x5555555555555555U);
        static_assert(kCellCorners == kBlockEdge);
        std::memcpy(&cases_[z / 2], words.data(), sizeof(words));
    }
}

std::vector<LayerBits> inside_layers(const BlockGrid& grid, std::span<const float> values) {
    std::vector<LayerBits> layers(grid.block_count());
    parallel_for(layers.size(), kGrain,
                 [&](std::size_t b) { layers[b] = layers_of_block(values.data() + b * kBlockNodes); });
    return layers;
}

std::vector<LayerBits> inside_layers(std::vector<InsideBits> inside) {
    static_assert(std::is_same_v<InsideBits, LayerBits>);  // each block's bits are put in order where they are
    parallel_for(inside.size(), kGrain, [&](std::size_t b) { inside[b] = layers_of_block(inside[b]); });
    return inside;
}

std::vector<CutEdges> find_cut_edges(const BlockGrid& grid, std::span<const LayerBits> inside) {
    std::vector<CutEdges> edges;
    resize_touched(edges, grid.block_count() + 1);
    parallel_for(grid.block_count(), kGrain, [&](std::size_t b) {
        edges[b].first_vertex = find_cut_edges(nodes_around(grid, inside, b), edges[b]);  // counts for now
    });
    std::size_t vertices = 0;
    for (CutEdges& e : edges) vertices += std::exchange(e.first_vertex, vertices);
    return edges;
}

}  // namespace meniscus
