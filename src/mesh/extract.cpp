// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/extract.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/fresh_memory.h"
#include "core/parallel.h"
#include "meniscus/errors.h"
#include "mesh/cell_cases.h"
#include "mesh/cut_edges.h"

namespace meniscus {
namespace {

constexpr std::size_t kGrain = 16;  // blocks per task: some tens of microseconds
constexpr std::size_t kTasks = 32;  // at once: what they make stays in a core's cache until it is appended

// Vertices on the cut edges of a block and of the nodes next to it: entry direction * kLocalNodes + local_node.
// Only the entries of cut edges are ever set or read.
using LocalVertices = std::array<VertexId, 3 * kLocalNodes>;

// Entry of a cell's edge, counted from the entry of the cell's own node along x.
constexpr std::array<std::size_t, kCellEdges> kEdgeOffsets = [] {
    std::array<std::size_t, kCellEdges> offsets{};
    for (int e = 0; e < kCellEdges; ++e) {
        const auto base = static_cast<std::size_t>(edge_base_corner(e));
        offsets[static_cast<std::size_t>(e)] = static_cast<std::size_t>(edge_direction(e)) * kLocalNodes +
                                               local_node(base & 1U, base >> 1U & 1U, base >> 2U);
    }
    return offsets;
}();

// Enters the vertices of a neighbour that lie next to the block; octant as in upper_neighbour, not 0.
void enter_neighbour(const CutEdges& edges, std::size_t octant, LocalVertices& local) {
    constexpr std::uint64_t kEverything = ~std::uint64_t{0};
    const bool x = (octant & 1U) != 0;
    const bool y = (octant & 2U) != 0;
    const bool z = (octant & 4U) != 0;
    const std::uint64_t keep = (x ? 0x0101010101010101ULL : kEverything) & (y ? 0xFFU : kEverything);
    const std::size_t shift = local_node(x ? kBlockEdge : 0, y ? kBlockEdge : 0, z ? kBlockEdge : 0);
    for (std::size_t d = 0; d < 3; ++d)
        for (std::size_t w = 0; w < (z ? 1 : kBlockEdge); ++w) {
            const std::uint64_t word = edges.bits[d][w];
            const std::size_t first = edges.first_vertex + edges.rank[d][w];
            for_each_bit(word & keep, [&](std::size_t bit) {
                const auto before = count_bits(word & ((std::uint64_t{1} << bit) - 1));
                local[d * kLocalNodes + shift + local_node(bit % kBlockEdge, bit / kBlockEdge, w)] =
                    static_cast<VertexId>(first + before);
            });
        }
}

// What belongs to some blocks in a row.
struct MeshPart {
    std::vector<Vec3> vertices;
    std::vector<Triangle> triangles;
};

// Where an edge is cut: halfway.
class Halfway {
public:
    static double root_fraction(std::size_t /*block*/, std::size_t /*direction*/, std::size_t /*node*/) { return 0.5; }
    static void fetch(std::size_t /*block*/) {}
};

// Where linear interpolation vanishes, but not near to nodes.
class Interpolated {
public:
    Interpolated(const BlockGrid& grid, std::span<const float> values, double nearest)
        : grid_(grid), values_(values), nearest_(nearest) {}

    // Where the edge from a node along a direction is cut, as a fraction of its length.
    double root_fraction(std::size_t block, std::size_t direction, std::size_t node) const {
        const double a = values_[block * kBlockNodes + node];
        const double b = value_beyond(block, direction, node);
        return std::min(std::max(nearest_, a / (a - b)), 1.0 - nearest_);
    }

    // Starts to bring a block into the cache: edges are cut here and there, which no processor foresees.
    void fetch(std::size_t block) const {
        constexpr std::size_t kLine = 16;  // values
        const std::size_t end = std::min((block + 1) * kBlockNodes, values_.size());
        for (std::size_t i = block * kBlockNodes; i < end; i += kLine) __builtin_prefetch(values_.data() + i);
    }

private:
    // Value at the far end of the edge from a node along a direction; the node must exist.
    double value_beyond(std::size_t block, std::size_t direction, std::size_t node) const {
        const std::size_t step = std::size_t{1} << (3 * direction);
        const std::size_t last = (kBlockEdge - 1) * step;
        if ((node & last) != last) return values_[block * kBlockNodes + node + step];
        const auto& around = grid_.neighbours(static_cast<BlockId>(block));
        const std::size_t next = upper_neighbour(around, std::size_t{1} << direction);
        return values_[next * kBlockNodes + (node & ~last)];
    }

    const BlockGrid& grid_;
    std::span<const float> values_;
    double nearest_;
};

// Makes the part of the mesh that belongs to one block.
template <class Roots>
class BlockFiller {
public:
    BlockFiller(const BlockGrid& grid, std::span<const CutEdges> edges, const Roots& roots)
        : grid_(grid), edges_(edges), roots_(roots) {}

    void fill(std::size_t block, const UnitsAround& units, MeshPart& part) const {
        roots_.fetch(block + 1);
        LocalVertices local;
        const std::size_t before = part.vertices.size();
        part.vertices.resize(before + edges_[block + 1].first_vertex - edges_[block].first_vertex);
        place_vertices(block, local, part.vertices.data() + before);
        const auto& around = grid_.neighbours(static_cast<BlockId>(block));
        for (std::size_t octant = 1; octant < 8; ++octant)
            if (units.exists[octant]) enter_neighbour(edges_[upper_neighbour(around, octant)], octant, local);
        connect(units, local, part.triangles);
    }

private:
    // Numbers the block's own vertices and sets their positions.
    void place_vertices(std::size_t block, LocalVertices& local, Vec3* out) const {
        constexpr std::array<Vec3, 3> kDirections{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
        const Vec3 corner = grid_.corner(static_cast<BlockId>(block));
        std::size_t vertex = edges_[block].first_vertex;
        for (std::size_t d = 0; d < 3; ++d)
            for (std::size_t z = 0; z < kBlockEdge; ++z)
                for_each_bit(edges_[block].bits[d][z], [&](std::size_t bit) {
                    const std::size_t x = bit % kBlockEdge;
                    const std::size_t y = bit / kBlockEdge;
                    local[d * kLocalNodes + local_node(x, y, z)] = static_cast<VertexId>(vertex++);
                    const double fraction = roots_.root_fraction(block, d, bit + z * kBlockEdge * kBlockEdge);
                    const Vec3 node{static_cast<double>(x), static_cast<double>(y), static_cast<double>(z)};
                    *out++ = corner + grid_.spacing() * (node + fraction * kDirections[d]);
                });
    }

    static void connect(const UnitsAround& units, const LocalVertices& local, std::vector<Triangle>& triangles) {
        std::array<Triangle, std::size_t{kMaxCellTriangles} * kBlockNodes> buffer;
        Triangle* out = buffer.data();
        for_each_cut_cell(units, [&](std::size_t cell, unsigned c) {
            const CellCase& cut = kCellCases[c];
            for (std::size_t t = 0; t < cut.count; ++t) {
                const auto& [e, f, g] = cut.triangles[t];
                *out++ = {local[cell + kEdgeOffsets[e]], local[cell + kEdgeOffsets[f]], local[cell + kEdgeOffsets[g]]};
            }
        });
        triangles.insert(triangles.end(), buffer.data(), out);
    }

    const BlockGrid& grid_;
    std::span<const CutEdges> edges_;
    const Roots& roots_;
};

// Of a closed surface, whose genus is small against its size; else memory is found anew.
std::size_t likely_triangles(std::size_t vertices) { return 2 * vertices + vertices / 16; }

template <class Roots>
Mesh extract(const BlockGrid& grid, std::span<const InsideBits> inside, const Roots& roots) {
    const std::vector<CutEdges> edges = find_cut_edges(grid, inside);
    const CutEdges& totals = edges.back();
    if (totals.first_vertex > std::numeric_limits<VertexId>::max())
        throw LimitError("the mesh would have " + std::to_string(totals.first_vertex) +
                         " vertices, more than 2^32 - 1; choose a larger --spacing");
    Mesh mesh;
    reserve_touched(mesh.vertices, with_spare(totals.first_vertex));
    reserve_touched(mesh.triangles, likely_triangles(totals.first_vertex));
    const BlockFiller<Roots> filler(grid, edges, roots);
    std::vector<MeshPart> parts(kTasks);
    for (std::size_t first = 0; first < grid.block_count(); first += kTasks * kGrain) {
        parallel_for(kTasks, 1, [&](std::size_t task) {
            parts[task].vertices.clear();
            parts[task].triangles.clear();
            const std::size_t begin = first + task * kGrain;
            for (std::size_t b = begin; b < std::min(begin + kGrain, grid.block_count()); ++b)
                if (const UnitsAround units = units_around(grid, inside, b); units.mixed)
                    filler.fill(b, units, parts[task]);
        });
        const auto append = [&](auto& all, auto MeshPart::*list) {
            for (const MeshPart& part : parts) all.insert(all.end(), (part.*list).begin(), (part.*list).end());
        };
        parallel_both([&] { append(mesh.vertices, &MeshPart::vertices); },
                      [&] { append(mesh.triangles, &MeshPart::triangles); });
    }
    return mesh;
}

}  // namespace

Mesh extract_zero_set(const BlockGrid& grid, std::span<const float> values, double nearest) {
    return extract(grid, inside_bits(grid, values), Interpolated(grid, values, nearest));
}

Mesh extract_between(const BlockGrid& grid, std::span<const InsideBits> inside) {
    return extract(grid, inside, Halfway());
}

}  // namespace meniscus
