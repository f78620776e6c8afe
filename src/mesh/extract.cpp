// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/extract.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "meniscus/errors.h"
#include "mesh/cell_cases.h"
#include "mesh/cut_edges.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kBlocksPerTask = 16;  // blocks per task: some tens of microseconds
constexpr std::size_t kTasks = 32;          // at once: what they make stays in a core's cache until it is appended

// Vertices on the cut edges of a block and of the nodes next to it: entry direction * kLocalNodes + local_node.
// Only the entries of cut edges are ever set or read.
using LocalVertices = std::array<VertexId, 3 * kLocalNodes>;

// Enters the vertices of a neighbour that lie next to the block, on edges that do not lead away from it. Octants (as in
// upper_neighbour) are constants here: what to do differs between them, and every block has all of them.
template <std::size_t kOctant>
void enter_neighbour(const CutEdges& edges, LocalVertices& local) {
    constexpr std::size_t kEdge = kBlockEdge;
    constexpr bool kX = (kOctant & 1U) != 0;
    constexpr bool kY = (kOctant & 2U) != 0;
    constexpr bool kZ = (kOctant & 4U) != 0;
    constexpr std::uint64_t kBeside = (kX ? kFirstColumn : ~std::uint64_t{0}) & (kY ? kFirstRow : ~std::uint64_t{0});
    constexpr std::size_t kFirst = local_node(kX ? kEdge : 0, kY ? kEdge : 0, kZ ? kEdge : 0);
    for (std::size_t d = 0; d < 3; ++d) {
        if ((kOctant >> d & 1U) != 0) continue;
        const LayerBits& bits = edges.bits[d];
        const auto enter = [&](std::size_t bit, std::size_t layer) {
            local[d * kLocalNodes + kFirst + node_of_bit(bit, layer)] =
                static_cast<VertexId>(edges.vertex(d, bit, layer));
        };
        // What is beside the block has room in one word, of all layers together: one loop instead of eight short ones.
        std::uint64_t together = 0;
        if constexpr (kZ) {
            for_each_bit(bits[0] & kBeside, [&](std::size_t bit) { enter(bit, 0); });
        } else if constexpr (kX) {
            for (std::size_t layer = 0; layer < kEdge; ++layer) together |= (bits[layer] & kBeside) << layer;
            for_each_bit(together, [&](std::size_t bit) { enter(bit / kEdge * kEdge, bit % kEdge); });
        } else {
            for (std::size_t layer = 0; layer < kEdge; ++layer) together |= (bits[layer] & kBeside) << (kEdge * layer);
            for_each_bit(together, [&](std::size_t bit) { enter(bit % kEdge, bit / kEdge); });
        }
    }
}

// The triangles of all cases by entries of LocalVertices, counted from the entry of a cell's own node along x.
class LocalTriangles {
public:
    // The triangles of one case; after the last one, the array repeats the first one.
    struct Case {
        std::uint16_t count;
        std::array<std::array<std::uint16_t, 3>, kMaxCellTriangles> triangles;
    };

    LocalTriangles() {
        for (std::size_t c = 0; c < cases_.size(); ++c) {
            const CellCase& cut = kCellCases[c];
            cases_[c].count = cut.count;
            for (std::size_t t = 0; t < kMaxCellTriangles; ++t)
                for (std::size_t k = 0; k < 3; ++k)
                    cases_[c].triangles[t][k] = entry_of(cut.triangles[t < cut.count ? t : 0][k]);
        }
    }
    const Case& operator[](std::size_t c) const { return cases_[c]; }

private:
    static std::uint16_t entry_of(int edge) {
        const auto base = static_cast<std::size_t>(edge_base_corner(edge));
        return static_cast<std::uint16_t>(static_cast<std::size_t>(edge_direction(edge)) * kLocalNodes +
                                          local_node(base & 1U, base >> 1U & 1U, base >> 2U));
    }

    std::array<Case, 256> cases_;
};

// Where an edge is cut: halfway.
class Halfway {
public:
    static double root_fraction(std::size_t /*block*/, std::size_t /*direction*/, std::size_t /*node*/) { return 0.5; }
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
    BlockFiller(const BlockGrid& grid, std::span<const LayerBits> inside, std::span<const CutEdges> edges,
                const Roots& roots)
        : grid_(grid), inside_(inside), edges_(edges), roots_(roots) {}

    // Appends it.
    void fill(std::size_t block, Mesh& mesh) const {
        const NodesAround nodes = nodes_around(grid_, inside_, block);
        const LayerBits cut = cut_cells(nodes);
        if (cut == LayerBits{} && edges_[block + 1].first_vertex == edges_[block].first_vertex) return;
        LocalVertices local;
        place_vertices(block, local, mesh.vertices);
        enter_neighbours(block, nodes.exists, local, std::make_index_sequence<6>());
        connect(nodes, cut, local, mesh.triangles);
    }

private:
    using NodeCoordinates = std::array<std::array<double, kBlockEdge>, 3>;  // by axis

    // Numbers the block's own vertices and appends their positions.
    void place_vertices(std::size_t block, LocalVertices& local, std::vector<Vec3>& vertices) const {
        constexpr std::array<double, kBlockEdge> kPlaces{0, 1, 2, 3, 4, 5, 6, 7};
        const Vec3 corner = grid_.corner(static_cast<BlockId>(block));
        NodeCoordinates nodes;
        for (std::size_t i = 0; i < kBlockEdge; ++i) {
            nodes[0][i] = corner.x + grid_.spacing() * kPlaces[i];
            nodes[1][i] = corner.y + grid_.spacing() * kPlaces[i];
            nodes[2][i] = corner.z + grid_.spacing() * kPlaces[i];
        }
        place_along<0>(block, nodes, local, vertices);
        place_along<1>(block, nodes, local, vertices);
        place_along<2>(block, nodes, local, vertices);
    }

    // The same for edges along one axis.
    template <std::size_t kAxis>
    void place_along(std::size_t block, const NodeCoordinates& nodes, LocalVertices& local,
                     std::vector<Vec3>& vertices) const {
        const CutEdges& edges = edges_[block];
        auto vertex = static_cast<VertexId>(edges.first_vertex + edges.rank[kAxis][0]);
        for (std::size_t z = 0; z < kBlockEdge; ++z)
            for_each_bit(edges.bits[kAxis][z], [&](std::size_t bit) {
                local[kAxis * kLocalNodes + node_of_bit(bit, z)] = vertex++;
                const std::array<std::size_t, 3> place{bit % kBlockEdge, bit / kBlockEdge, z};
                const double fraction = roots_.root_fraction(block, kAxis, bit + z * kBlockEdge * kBlockEdge);
                std::array<double, 3> at{nodes[0][place[0]], nodes[1][place[1]], nodes[2][place[2]]};
                at[kAxis] = nodes[kAxis][0] + grid_.spacing() * (static_cast<double>(place[kAxis]) + fraction);
                vertices.push_back({at[0], at[1], at[2]});
            });
    }

    // No cell has an edge that begins in the neighbour beyond all three sides, the seventh.
    template <std::size_t... kLower>
    void enter_neighbours(std::size_t block, const std::array<bool, 8>& exists, LocalVertices& local,
                          std::index_sequence<kLower...> /*octants*/) const {
        const auto& around = grid_.neighbours(static_cast<BlockId>(block));
        const auto edges = [&](std::size_t octant) -> const CutEdges& {
            return edges_[upper_neighbour(around, octant)];
        };
        ((exists[kLower + 1] ? enter_neighbour<kLower + 1>(edges(kLower + 1), local) : void()), ...);
    }

    void connect(const NodesAround& nodes, const LayerBits& cut, const LocalVertices& local,
                 std::vector<Triangle>& triangles) const {
        constexpr std::size_t kSpare = kMaxCellTriangles;
        std::array<Triangle, std::size_t{kMaxCellTriangles} * kBlockNodes + kSpare> buffer;
        Triangle* out = buffer.data();
        const CellCases cases(nodes);
        for (std::size_t z = 0; z < kBlockEdge; ++z)
            for_each_bit(cut[z], [&](std::size_t bit) {
                const LocalTriangles::Case& cell = cases_[cases(bit, z)];
                const VertexId* const from = local.data() + node_of_bit(bit, z);
                const auto put = [&](std::size_t t) {
                    const auto& [e, f, g] = cell.triangles[t];
                    out[t] = {from[e], from[f], from[g]};
                };
                // Two at least, because that can be foreseen.
                put(0);
                put(1);
                if (cell.count > 2) {
                    put(2);
                    put(3);
                    if (cell.count > 4) put(4);
                }
                out += cell.count;
            });
        triangles.insert(triangles.end(), buffer.data(), out);
    }

    const BlockGrid& grid_;
    std::span<const LayerBits> inside_;
    std::span<const CutEdges> edges_;
    const Roots& roots_;
    LocalTriangles cases_;
};

template <class Roots>
Mesh extract(const BlockGrid& grid, std::span<const LayerBits> inside, const Roots& roots) {
    const std::vector<CutEdges> edges = find_cut_edges(grid, inside);
    const CutEdges& totals = edges.back();
    // A closed surface of small genus has no more triangles. They are numbered by 32 bits, as vertices are.
    const std::uint64_t triangles = 2 * totals.first_vertex + totals.first_vertex / 16;
    if (triangles > std::numeric_limits<std::uint32_t>::max())
        throw LimitError("the mesh would have " + std::to_string(totals.first_vertex) +
                         " vertices, more than are possible with 2^32 - 1 triangles; choose a larger spacing");
    Mesh mesh;
    reserve_touched(mesh.vertices, with_spare(totals.first_vertex));
    // A sphere's triangles are likely, the others are seldom used; for more than these memory is found anew.
    reserve_touched(mesh.triangles, triangles, 2 * totals.first_vertex);
    const BlockFiller<Roots> filler(grid, inside, edges, roots);
    if (is_alone()) {  // every block goes to where it stays, with nothing to append
        for (std::size_t b = 0; b < grid.block_count(); ++b) filler.fill(b, mesh);
        return mesh;
    }
    std::vector<Mesh> parts(kTasks);
    for (std::size_t first = 0; first < grid.block_count(); first += kTasks * kBlocksPerTask) {
        parallel_for(kTasks, 1, [&](std::size_t task) {
            parts[task].vertices.clear();
            parts[task].triangles.clear();
            const std::size_t begin = first + task * kBlocksPerTask;
            for (std::size_t b = begin; b < std::min(begin + kBlocksPerTask, grid.block_count()); ++b)
                filler.fill(b, parts[task]);
        });
        const auto append = [&](auto Mesh::*list) {
            for (const Mesh& part : parts)
                (mesh.*list).insert((mesh.*list).end(), (part.*list).begin(), (part.*list).end());
        };
        parallel_both([&] { append(&Mesh::vertices); }, [&] { append(&Mesh::triangles); });
    }
    return mesh;
}

}  // namespace

Mesh extract_zero_set(const BlockGrid& grid, std::span<const float> values, double nearest) {
    return extract(grid, inside_layers(grid, values), Interpolated(grid, values, nearest));
}

Mesh extract_between(const BlockGrid& grid, std::vector<InsideBits> inside) {
    return extract(grid, inside_layers(std::move(inside)), Halfway());
}

}  // namespace meniscus
