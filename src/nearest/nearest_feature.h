// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From a nearest ball, arc or vertex of the SAS to all that is said about it.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include "geometry/accessible_surface_data.h"

namespace meniscus {

/// The ball that contains a point most deeply, or is nearest to it.
struct NearestBall {
    std::uint32_t atom = 0;
    double depth = -std::numeric_limits<double>::infinity();  ///< rho - l: positive inside the ball
    double l = 0.0;                                           ///< distance from the atom's centre

    void offer(std::uint32_t candidate, double candidate_depth, double candidate_l) {
        if (candidate_depth > depth || (candidate_depth == depth && candidate < atom))
            *this = {candidate, candidate_depth, candidate_l};
    }
};

/// The nearest arc or vertex.
struct NearestEdge {
    double squared_distance = std::numeric_limits<double>::infinity();
    std::uint32_t arc = 0;
    std::uint32_t vertex = kNoVertex;  ///< kNoVertex: the arc is nearest

    bool found() const { return squared_distance < std::numeric_limits<double>::infinity(); }
    void offer_vertex(std::uint32_t candidate, double candidate_squared_distance) {
        if (candidate_squared_distance < squared_distance) *this = {candidate_squared_distance, 0, candidate};
    }
    void offer_arc(std::uint32_t candidate, const ArcFoot& foot) {
        if (foot.within && foot.squared_distance < squared_distance)
            *this = {foot.squared_distance, candidate, kNoVertex};
    }
};

/// Whether the nearest point of the SAS is the point of the ball's sphere in the direction of p.
///
/// dist(p, K) >= depth of p in every ball, with equality exactly where that direction is exposed: so only the
/// deepest ball can own p. Outside all balls (in K) the nearest ball always does.
inline bool owned_by_ball(const AccessibleSurface::Data& data, const NearestBall& ball, const Vec3& p) {
    return ball.depth <= 0.0 || (data.exposed[ball.atom] != 0 &&
                                 data.direction_exposed(ball.atom, p - data.atoms.centres[ball.atom], ball.l));
}

/// The nearest ball or edge of any point, by branch and bound.
struct NearestHit {
    bool by_ball = true;
    NearestBall ball;
    NearestEdge edge;
};
NearestHit nearest_hit(const AccessibleSurface::Data& data, const Vec3& p);

/// A feature of the SAS by its number, and the cell where it is known to be the nearest one (feature_walk.h).
struct FeatureCell {
    enum class Kind : std::uint32_t { None, Ball, Arc, Vertex };
    Kind kind = Kind::None;
    std::uint32_t index = 0;  ///< of the atom, arc or vertex

    friend bool operator==(const FeatureCell&, const FeatureCell&) = default;
};

/// What a vertex of a mesh is labelled with.
struct FeatureLabel {
    double signed_distance = 0.0;
    std::uint32_t atom = 0;  ///< as in NearestFeature
    PatchKind patch = PatchKind::Contact;
};
inline FeatureLabel label_of(const NearestFeature& feature) {
    return {feature.signed_distance, feature.atom, feature.patch};
}
/// Of the atoms of an arc or vertex, the one whose van der Waals sphere is nearest to p; in the caller's order.
std::uint32_t atom_of_arc(const AccessibleSurface::Data& data, std::uint32_t arc, const Vec3& p);
std::uint32_t atom_of_vertex(const AccessibleSurface::Data& data, std::uint32_t vertex, const Vec3& p);

/// What is nearest to p, where it is known which feature is.
NearestFeature feature_in(const AccessibleSurface::Data& data, const Vec3& p, const FeatureCell& nearest);

/// What p is labelled with whose nearest feature is that.
FeatureLabel label_in(const AccessibleSurface::Data& data, const Vec3& p, const FeatureCell& nearest);
/// The same where the signed distance is known, Å.
FeatureLabel label_in(const AccessibleSurface::Data& data, const Vec3& p, const FeatureCell& nearest,
                      double signed_distance);

NearestFeature contact_feature(const AccessibleSurface::Data& data, const Vec3& p, const NearestBall& ball);
NearestFeature edge_feature(const AccessibleSurface::Data& data, const Vec3& p, const NearestEdge& edge);

/// Where a step along the distance leads, and what is nearest there.
struct SurfaceStep {
    Vec3 point;
    NearestFeature feature;  ///< of the point that was left, at `point`
    bool settled = false;    ///< it is the nearest one at `point`, too, which therefore lies on the surface
};

/// A step from p, whose nearest feature is the ball, arc or vertex, to the surface.
///
/// The step goes along the line through p and its foot x on the SAS, to the distance of the probe's radius from x. In a
/// ball that owns p it keeps the direction, which is exposed, and the ball: settled. x stays the nearest point of K
/// all the way from c to x if the balls around the atoms of an arc or vertex cover the ball around c through x, and
/// they do for every c in the hull of x and these atoms. So a step towards x is settled, and one away from x until it
/// leaves the hull through its far side: the axis of the arc's circle, the plane of the vertex's three atoms.
SurfaceStep step_from_ball(const AccessibleSurface::Data& data, const Vec3& p, std::uint32_t atom);
SurfaceStep step_from_arc(const AccessibleSurface::Data& data, const Vec3& p, std::uint32_t arc);
SurfaceStep step_from_vertex(const AccessibleSurface::Data& data, const Vec3& p, std::uint32_t vertex);
SurfaceStep step_from(const AccessibleSurface::Data& data, const Vec3& p, const FeatureCell& nearest);

/// The hull of a vertex and its three atoms: where all parts, linear in a point's place, are positive and their sum is
/// less than the whole. A part is that of the distance of an atom from the opposite face, times `whole`.
struct VertexHull {
    Vec3 position;                ///< of the vertex
    std::array<Vec3, 3> normals;  ///< of the faces opposite to the atoms, inwards; as long as to make up the parts
    double whole = 0.0;           ///< six times the volume, Å³

    std::array<double, 3> parts_of(const Vec3& p) const {
        const Vec3 q = p - position;
        return {dot(q, normals[0]), dot(q, normals[1]), dot(q, normals[2])};
    }
};
inline VertexHull vertex_hull(const AccessibleSurface::Data& data, const SasVertex& vertex) {
    const Vec3 a = data.atoms.centres[vertex.atoms[0]] - vertex.position;
    const Vec3 b = data.atoms.centres[vertex.atoms[1]] - vertex.position;
    const Vec3 c = data.atoms.centres[vertex.atoms[2]] - vertex.position;
    const Vec3 bc = cross(b, c);
    const double whole = dot(a, bc);
    const double turn = whole < 0.0 ? -1.0 : 1.0;
    return {vertex.position, {turn * bc, turn * cross(c, a), turn * cross(a, b)}, turn * whole};
}
inline bool in_vertex_cell(const AccessibleSurface::Data& data, const SasVertex& vertex, const Vec3& p) {
    const VertexHull hull = vertex_hull(data, vertex);
    const std::array<double, 3> parts = hull.parts_of(p);
    return parts[0] >= 0.0 && parts[1] >= 0.0 && parts[2] >= 0.0 && parts[0] + parts[1] + parts[2] <= hull.whole;
}

}  // namespace meniscus
