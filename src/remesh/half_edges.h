// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How the triangles of a closed mesh hang together, in a form that local changes keep valid.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Half-edge 3 t + k runs along triangle t from its corner k to the next one.
using HalfEdge = std::uint32_t;
inline constexpr HalfEdge kNoHalfEdge = std::numeric_limits<HalfEdge>::max();

constexpr HalfEdge next(HalfEdge h) { return h % 3 == 2 ? h - 2 : h + 1; }
constexpr HalfEdge previous(HalfEdge h) { return h % 3 == 0 ? h + 2 : h - 1; }

/// The connectivity of a closed oriented 2-manifold. flip, split and collapse keep it one, with the same topology.
///
/// Removed vertices and triangles leave holes in the numbering.
class HalfEdges {
public:
    /// throws   std::invalid_argument where an edge has not exactly two triangles that run along it in opposite
    ///          directions; LimitError for more than 2^32 / 3 triangles
    /// cost     O(n) for a bounded number of triangles round each vertex
    HalfEdges(std::size_t vertices, std::span<const Triangle> triangles);

    /// Numbers given so far, those of removed ones included.
    std::size_t vertex_slots() const { return leaving_.size(); }
    std::size_t half_edge_slots() const { return origin_.size(); }

    bool has_vertex(VertexId v) const { return leaving_[v] != kNoHalfEdge; }
    bool has(HalfEdge h) const { return twin_[h] != kNoHalfEdge; }

    VertexId origin(HalfEdge h) const { return origin_[h]; }
    VertexId target(HalfEdge h) const { return origin_[next(h)]; }
    /// The corner of the triangle that the half-edge does not touch.
    VertexId opposite(HalfEdge h) const { return origin_[previous(h)]; }
    HalfEdge twin(HalfEdge h) const { return twin_[h]; }
    HalfEdge leaving(VertexId v) const { return leaving_[v]; }

    /// Calls visit(h) for the half-edges that leave a vertex, clockwise.
    template <class Visit>
    void for_each_leaving(VertexId v, const Visit& visit) const {
        const HalfEdge first = leaving_[v];
        HalfEdge h = first;
        do {
            const HalfEdge after = next(twin_[h]);
            visit(h);
            h = after;
        } while (h != first);
    }
    std::size_t valence(VertexId v) const;
    bool are_neighbours(VertexId a, VertexId b) const;
    /// The half-edge from a vertex to another; kNoHalfEdge where they are not neighbours.
    HalfEdge between(VertexId a, VertexId b) const;

    /// Whether the edge can turn within its two triangles without doubling another edge.
    bool can_flip(HalfEdge h) const;
    void flip(HalfEdge h);

    /// Puts a vertex into an edge, which becomes two: h then ends at the new vertex. Returns its number.
    VertexId split(HalfEdge h);

    /// Whether moving the edge's origin into its target leaves the topology as it is (the link condition).
    bool can_collapse(HalfEdge h) const;
    /// Removes the edge's origin and its two triangles.
    void collapse(HalfEdge h);

    /// The vertices that are left, rising.
    std::vector<VertexId> vertices() const;
    /// The triangles that are left, with new numbers of their corners: their places in `order`, which has every vertex
    /// that is left. Sorted by the least of them, which comes first.
    std::vector<Triangle> triangles(std::span<const VertexId> order) const;

private:
    void pair(HalfEdge a, HalfEdge b) {
        twin_[a] = b;
        twin_[b] = a;
    }
    HalfEdge add_triangle(VertexId a, VertexId b, VertexId c);
    void find_twins(std::size_t vertices);
    void remove_triangle_of(HalfEdge h);

    std::vector<VertexId> origin_;   // per half-edge
    std::vector<HalfEdge> twin_;     // per half-edge; kNoHalfEdge where its triangle was removed
    std::vector<HalfEdge> leaving_;  // per vertex: one of those that leave it; kNoHalfEdge where it was removed
};

}  // namespace meniscus
