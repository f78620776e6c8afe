// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A mesh under change: its connectivity, where its vertices lie on the surface, and what its triangles look like.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/mesh.h"
#include "remesh/half_edges.h"
#include "remesh/remesher.h"
#include "space/box_tree.h"

namespace meniscus {

/// Twice the area along the normal by the right-hand rule.
inline Vec3 area_vector(const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); }

/// Cosine of a triangle's smallest angle: 0.5 for an equilateral one, 1 for one without area. Cheaper than the angle.
inline double cosine_of_smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double ab = squared_norm(b - a);
    const double bc = squared_norm(c - b);
    const double ca = squared_norm(a - c);
    // The smallest angle lies opposite the shortest side.
    const double shortest = std::min({ab, bc, ca});
    const double product = ab == shortest ? bc * ca : (bc == shortest ? ca * ab : ab * bc);
    return product > 0.0 ? (ab + bc + ca - 2.0 * shortest) / (2.0 * std::sqrt(product)) : 1.0;
}

/// Edges longer than this part of the target length are split (Botsch & Kobbelt 2004).
inline constexpr double kLongEdge = 4.0 / 3.0;

/// What must not change about a vertex.
enum class Hold : std::uint8_t {
    Free,
    Ridge,   ///< stays where it is, and edges to others of its kind stay
    Frozen,  ///< nothing round it changes
};

/// All that lies within a reach of some places.
class Surroundings {
public:
    /// reach  Å
    Surroundings(std::span<const Vec3> places, double reach)
        : places_(places.begin(), places.end()), reach_(reach), tree_(boxes_round(places)) {}

    bool contain(const Vec3& point) const {
        bool found = false;
        tree_.for_each_overlapping(Box{point, point}.grown(reach_), [&](std::uint32_t i) {
            found = found || squared_norm(point - places_[i]) < reach_ * reach_;
        });
        return found;
    }

private:
    static std::vector<Box> boxes_round(std::span<const Vec3> places) {
        std::vector<Box> boxes;
        boxes.reserve(places.size());
        for (const Vec3& place : places) boxes.push_back({place, place});
        return boxes;
    }

    std::vector<Vec3> places_;
    double reach_;
    BoxTree tree_;
};

struct WorkingMesh {
    HalfEdges edges;
    std::vector<SurfacePoint> points;  ///< per vertex
    std::vector<Hold> holds;           ///< per vertex
    std::vector<double> targets;       ///< per vertex: length that its edges should have, Å

    WorkingMesh(const Mesh& mesh, double edge);

    /// The same without the room of what was removed, vertices in another order and triangles in theirs.
    WorkingMesh renumbered(std::span<const VertexId> order) const;

    const Vec3& at(VertexId v) const { return points[v].position; }
    double squared_length(HalfEdge h) const { return squared_norm(at(edges.target(h)) - at(edges.origin(h))); }
    double target(VertexId a, VertexId b) const { return 0.5 * (targets[a] + targets[b]); }

    /// From 0.5 to 1: the cosine of the smallest angle.
    double badness(VertexId a, VertexId b, VertexId c) const { return cosine_of_smallest_angle(at(a), at(b), at(c)); }
    double badness(HalfEdge h) const { return badness(edges.origin(h), edges.target(h), edges.opposite(h)); }
    double worst_round(VertexId v) const;

    /// Whether the surface turns by more than 105 degrees between two vertices: round a narrow neck edges must stay
    /// shorter than that, or the mesh would pass through itself.
    static constexpr double kTurn = -0.25;
    bool turns_away(VertexId a, VertexId b) const { return dot(points[a].normal, points[b].normal) < kTurn; }

    /// Whether a triangle faces the way the surface does at its corners, within 60 degrees.
    bool faces_out(VertexId a, VertexId b, VertexId c) const;
    bool all_face_out_round(VertexId v) const;

    bool is_ridge(HalfEdge h) const {
        return holds[edges.origin(h)] == Hold::Ridge && holds[edges.target(h)] == Hold::Ridge;
    }

    /// Calls visit(h) for one half-edge of every edge; those that visit adds are visited, too.
    template <class Visit>
    void for_each_edge(const Visit& visit) {
        for (HalfEdge h = 0; h < edges.half_edge_slots(); ++h)
            if (edges.has(h) && h < edges.twin(h)) visit(h);
    }

    /// The worst triangle that moving an edge's origin into its target would leave; kRefused where that is not allowed:
    /// a triangle would turn over, become a sliver worse than all before, or have an edge that is too long.
    static constexpr double kRefused = 2.0;
    double badness_after_collapse(HalfEdge h) const;
    /// Removes the edge's origin or its target, whichever leaves better triangles, if that leaves none worse than
    /// `at_most`. Returns whether it did.
    bool collapse(HalfEdge h, double at_most);

    struct Flip {
        double before = 0.0;  ///< badness of the worse triangle
        double after = 0.0;
        bool allowed = false;
    };
    /// The way in which new triangles must face: out, or out only if the old ones do.
    enum class Facing : std::uint8_t { Out, AsBefore };
    Flip try_flip(HalfEdge h, Facing facing) const;

    /// Puts a vertex into the middle of an edge; the surface's point there is still to be found.
    VertexId split(HalfEdge h);
};

}  // namespace meniscus
