// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The nearest feature of the SAS for any point of space, by branch and bound.
#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "geometry/nearest_feature.h"
#include "geometry/parallel_curvature.h"
#include "meniscus/accessible_surface.h"

namespace meniscus {
namespace {

using Data = AccessibleSurface::Data;

// The ball that contains p most deeply, or is nearest to it.
NearestBall deepest_ball(const Data& data, const Vec3& p) {
    NearestBall best;
    const auto bound = [&] {
        const double reach = data.rho_max - best.depth;
        return reach > 0.0 ? reach * reach : 0.0;
    };
    data.atom_tree.search_nearest(p, bound, [&](std::uint32_t i) {
        const double l = norm(p - data.atoms.centres[i]);
        best.offer(i, data.rho[i] - l, l);
    });
    return best;
}

// Of some atoms, the one whose van der Waals sphere is nearest to p, in the caller's numbering.
template <std::size_t N>
std::uint32_t nearest_atom(const Data& data, const std::array<std::uint32_t, N>& atoms, const Vec3& p) {
    const auto gap = [&](std::uint32_t i) { return norm(p - data.atoms.centres[i]) - data.atoms.radii[i]; };
    return data.atoms.original[*std::min_element(atoms.begin(), atoms.end(),
                                                 [&](std::uint32_t a, std::uint32_t b) { return gap(a) < gap(b); })];
}

NearestEdge nearest_edge(const Data& data, const Vec3& p) {
    NearestEdge best;
    const auto bound = [&] { return best.squared_distance; };
    data.vertex_tree.search_nearest(
        p, bound, [&](std::uint32_t v) { best.offer_vertex(v, squared_norm(p - data.vertices[v].position)); });
    data.arc_tree.search_nearest(p, bound, [&](std::uint32_t a) { best.offer_arc(a, foot_on_arc(data.arcs[a], p)); });
    return best;
}

void point_towards_foot(NearestFeature& feature, const Vec3& p, double distance) {
    if (distance > 0.0) feature.normal = (1.0 / distance) * (feature.foot - p);
}

}  // namespace

NearestFeature contact_feature(const Data& data, const Vec3& p, const NearestBall& ball) {
    const Vec3& centre = data.atoms.centres[ball.atom];
    NearestFeature feature;
    feature.signed_distance = data.probe - ball.depth;
    feature.patch = PatchKind::Contact;
    feature.atom = data.atoms.original[ball.atom];
    feature.mean_curvature = contact_curvature(ball.l);
    feature.gaussian_curvature = contact_gaussian_curvature(ball.l);
    feature.normal = ball.l > 0.0 ? (1.0 / ball.l) * (p - centre) : Vec3{};
    feature.foot = centre + data.rho[ball.atom] * (ball.l > 0.0 ? feature.normal : Vec3{0.0, 0.0, 1.0});
    return feature;
}

NearestFeature edge_feature(const Data& data, const Vec3& p, const NearestEdge& edge) {
    const double distance = std::sqrt(edge.squared_distance);
    NearestFeature feature;
    feature.signed_distance = data.probe - distance;
    if (edge.vertex != kNoVertex) {
        const SasVertex& vertex = data.vertices[edge.vertex];
        feature.patch = PatchKind::Reentrant;
        feature.atom = nearest_atom(data, vertex.atoms, p);
        feature.mean_curvature = reentrant_curvature(distance);
        feature.gaussian_curvature = reentrant_gaussian_curvature(distance);
        feature.foot = vertex.position;
    } else {
        const SasArc& arc = data.arcs[edge.arc];
        const ArcFoot foot = foot_on_arc(arc, p);
        const Vec3 radial = foot.from_axis > 0.0 ? (1.0 / foot.from_axis) * foot.radial : arc.middle;
        feature.patch = PatchKind::Toroidal;
        feature.atom = nearest_atom(data, arc.atoms, p);
        feature.mean_curvature = toroidal_curvature(arc.radius, foot.from_axis, distance);
        feature.gaussian_curvature = toroidal_gaussian_curvature(arc.radius, foot.from_axis, distance);
        feature.foot = arc.centre + arc.radius * radial;
    }
    point_towards_foot(feature, p, distance);
    return feature;
}

NearestHit nearest_hit(const AccessibleSurface::Data& data, const Vec3& p) {
    NearestHit hit;
    hit.ball = deepest_ball(data, p);
    hit.by_ball = owned_by_ball(data, hit.ball, p);
    if (!hit.by_ball) hit.edge = nearest_edge(data, p);
    hit.by_ball = hit.by_ball || !hit.edge.found();
    return hit;
}

NearestFeature AccessibleSurface::nearest(const Vec3& point) const {
    const NearestHit hit = nearest_hit(*data_, point);
    return hit.by_ball ? contact_feature(*data_, point, hit.ball) : edge_feature(*data_, point, hit.edge);
}

std::vector<double> signed_distance(const AccessibleSurface& surface, std::span<const Vec3> points) {
    std::vector<double> distances(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!is_finite(points[i])) throw std::invalid_argument("point " + std::to_string(i) + " is not finite");
        distances[i] = surface.nearest(points[i]).signed_distance;
    }
    return distances;
}

}  // namespace meniscus
