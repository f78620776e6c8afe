// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The nearest feature of the SAS for any point of space, by branch and bound.
#include <algorithm>
#include <cmath>

#include "geometry/accessible_surface.h"
#include "nearest/nearest_feature.h"
#include "nearest/parallel_curvature.h"

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

// Of some atoms, the one whose van der Waals sphere is nearest to p.
template <std::size_t N>
std::uint32_t nearest_atom(const Data& data, const std::array<std::uint32_t, N>& atoms, const Vec3& p) {
    std::uint32_t nearest = atoms[0];
    double least = std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : atoms) {
        const double gap = norm(p - data.atoms.centres[i]) - data.atoms.radii[i];
        nearest = gap < least ? i : nearest;
        least = gap < least ? gap : least;
    }
    return nearest;
}

NearestEdge nearest_edge(const Data& data, const Vec3& p) {
    NearestEdge best;
    const auto bound = [&] { return best.squared_distance; };
    data.vertex_tree.search_nearest(
        p, bound, [&](std::uint32_t v) { best.offer_vertex(v, squared_norm(p - data.vertices[v].position)); });
    data.arc_tree.search_nearest(p, bound, [&](std::uint32_t a) { best.offer_arc(a, foot_on_arc(data.arcs[a], p)); });
    return best;
}

struct Foot {
    Vec3 place;
    double distance;  // of p, Å
};

// A feature whose atom and foot are known, without its patch and curvatures. The gradient points towards the foot.
// Where that is p but for rounding errors there is none; without a probe such points are on the surface, where spheres
// meet, and look the way the nearest sphere does.
NearestFeature feature_at(const Data& data, const Vec3& p, std::uint32_t atom, const Foot& foot) {
    constexpr double kRounding = 1e-10;  // Å
    NearestFeature feature;
    feature.signed_distance = data.probe - foot.distance;
    feature.atom = data.atoms.original[atom];
    feature.foot = foot.place;
    if (foot.distance > kRounding)
        feature.normal = (1.0 / foot.distance) * (foot.place - p);
    else if (data.probe == 0.0)
        feature.normal = normalised(p - data.atoms.centres[atom]);
    return feature;
}

NearestFeature vertex_feature(const Data& data, const Vec3& p, std::uint32_t v) {
    const SasVertex& vertex = data.vertices[v];
    const double distance = norm(p - vertex.position);
    NearestFeature feature = feature_at(data, p, nearest_atom(data, vertex.atoms, p), {vertex.position, distance});
    feature.patch = PatchKind::Reentrant;
    feature.mean_curvature = reentrant_curvature(distance);
    feature.gaussian_curvature = reentrant_gaussian_curvature(distance);
    return feature;
}

NearestFeature arc_feature(const Data& data, const Vec3& p, std::uint32_t a) {
    const SasArc& arc = data.arcs[a];
    const ArcFoot foot = foot_on_arc(arc, p);
    const double distance = std::sqrt(foot.squared_distance);
    const Vec3 radial = foot.from_axis > 0.0 ? (1.0 / foot.from_axis) * foot.radial : arc.middle;
    NearestFeature feature =
        feature_at(data, p, nearest_atom(data, arc.atoms, p), {arc.centre + arc.radius * radial, distance});
    feature.patch = PatchKind::Toroidal;
    feature.mean_curvature = toroidal_curvature(arc.radius, foot.from_axis, distance);
    feature.gaussian_curvature = toroidal_gaussian_curvature(arc.radius, foot.from_axis, distance);
    return feature;
}

}  // namespace

std::uint32_t atom_of_arc(const Data& data, std::uint32_t arc, const Vec3& p) {
    return data.atoms.original[nearest_atom(data, data.arcs[arc].atoms, p)];
}

std::uint32_t atom_of_vertex(const Data& data, std::uint32_t vertex, const Vec3& p) {
    return data.atoms.original[nearest_atom(data, data.vertices[vertex].atoms, p)];
}

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
    const bool by_vertex = edge.vertex != kNoVertex;
    return feature_in(data, p,
                      by_vertex ? FeatureCell{FeatureCell::Kind::Vertex, edge.vertex}
                                : FeatureCell{FeatureCell::Kind::Arc, edge.arc});
}

// Where a step is settled, the feature's foot and the direction to it are those of p, and the distance from it is the
// probe's radius.
SurfaceStep step_from_ball(const Data& data, const Vec3& p, std::uint32_t atom) {
    const Vec3& centre = data.atoms.centres[atom];
    const double l = norm(p - centre);
    if (!(l > 0.0)) return {p, contact_feature(data, p, {atom, data.rho[atom] - l, l}), false};
    const Vec3 direction = (1.0 / l) * (p - centre);
    const double radius = data.rho[atom] - data.probe;
    SurfaceStep step;
    step.settled = true;
    step.point = p - (l - radius) * direction;
    step.feature.patch = PatchKind::Contact;
    step.feature.atom = data.atoms.original[atom];
    step.feature.mean_curvature = contact_curvature(radius);
    step.feature.gaussian_curvature = contact_gaussian_curvature(radius);
    step.feature.foot = centre + data.rho[atom] * direction;
    step.feature.normal = direction;
    return step;
}

SurfaceStep step_from_arc(const Data& data, const Vec3& p, std::uint32_t a) {
    const SasArc& arc = data.arcs[a];
    const ArcFoot before = foot_on_arc(arc, p);
    const double distance = std::sqrt(before.squared_distance);
    const double probe = data.probe;
    SurfaceStep step;
    step.point = p;
    const bool steps = before.from_axis > 0.0 && distance > 0.0;
    if (steps) {
        step.feature.foot = arc.centre + (arc.radius / before.from_axis) * before.radial;
        step.feature.normal = (1.0 / distance) * (step.feature.foot - p);
        step.point = p - (probe - distance) * step.feature.normal;
    }
    const bool crosses_axis = arc.radius * distance <= probe * (arc.radius - before.from_axis);
    // The cell is a wedge with its edge in the foot: the step neither enters nor leaves it but through the axis.
    step.settled = steps && (distance >= probe || (!crosses_axis && in_arc_cell(arc, before)));
    if (!step.settled || !(probe > 0.0)) {
        step.feature = arc_feature(data, step.point, a);
        return step;
    }
    const double from_axis = arc.radius - probe / distance * (arc.radius - before.from_axis);
    step.feature.patch = PatchKind::Toroidal;
    step.feature.atom = atom_of_arc(data, a, step.point);
    step.feature.mean_curvature = toroidal_curvature(arc.radius, from_axis, probe);
    step.feature.gaussian_curvature = toroidal_gaussian_curvature(arc.radius, from_axis, probe);
    return step;
}

SurfaceStep step_from_vertex(const Data& data, const Vec3& p, std::uint32_t v) {
    const SasVertex& vertex = data.vertices[v];
    const Vec3 to_foot = vertex.position - p;
    const double distance = norm(to_foot);
    const double probe = data.probe;
    SurfaceStep step;
    step.feature.normal = distance > 0.0 ? (1.0 / distance) * to_foot : Vec3{};
    step.point = p - (probe - distance) * step.feature.normal;
    step.settled = distance > 0.0 && (distance >= probe || in_vertex_cell(data, vertex, step.point));
    if (!step.settled || !(probe > 0.0)) {
        step.feature = vertex_feature(data, step.point, v);
        return step;
    }
    step.feature.patch = PatchKind::Reentrant;
    step.feature.atom = atom_of_vertex(data, v, step.point);
    step.feature.mean_curvature = reentrant_curvature(probe);
    step.feature.gaussian_curvature = reentrant_gaussian_curvature(probe);
    step.feature.foot = vertex.position;
    return step;
}

SurfaceStep step_from(const Data& data, const Vec3& p, const FeatureCell& nearest) {
    switch (nearest.kind) {
        case FeatureCell::Kind::Ball:
            return step_from_ball(data, p, nearest.index);
        case FeatureCell::Kind::Arc:
            return step_from_arc(data, p, nearest.index);
        default:
            return step_from_vertex(data, p, nearest.index);
    }
}

NearestFeature feature_in(const Data& data, const Vec3& p, const FeatureCell& nearest) {
    switch (nearest.kind) {
        case FeatureCell::Kind::Ball: {
            const double l = norm(p - data.atoms.centres[nearest.index]);
            return contact_feature(data, p, {nearest.index, data.rho[nearest.index] - l, l});
        }
        case FeatureCell::Kind::Arc:
            return arc_feature(data, p, nearest.index);
        default:
            return vertex_feature(data, p, nearest.index);
    }
}

FeatureLabel label_in(const Data& data, const Vec3& p, const FeatureCell& nearest, double signed_distance) {
    switch (nearest.kind) {
        case FeatureCell::Kind::Ball:
            return {signed_distance, data.atoms.original[nearest.index], PatchKind::Contact};
        case FeatureCell::Kind::Arc:
            return {signed_distance, atom_of_arc(data, nearest.index, p), PatchKind::Toroidal};
        default:
            return {signed_distance, atom_of_vertex(data, nearest.index, p), PatchKind::Reentrant};
    }
}

FeatureLabel label_in(const Data& data, const Vec3& p, const FeatureCell& nearest) {
    const auto distance_from_k = [&] {
        switch (nearest.kind) {
            case FeatureCell::Kind::Ball:
                return data.rho[nearest.index] - norm(p - data.atoms.centres[nearest.index]);
            case FeatureCell::Kind::Arc:
                return std::sqrt(foot_on_arc(data.arcs[nearest.index], p).squared_distance);
            default:
                return norm(p - data.vertices[nearest.index].position);
        }
    };
    return label_in(data, p, nearest, data.probe - distance_from_k());
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

}  // namespace meniscus
