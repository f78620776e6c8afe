// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/ridges.h"

#include <optional>

#include "simd/tangent_planes.h"

namespace meniscus {
namespace {

// Over an edge of a grid of 0.5 Å the normal of a smooth surface turns by less than this, 50 degrees.
constexpr double kCrease = 0.64;

// How far a point of a crease may be from the edge that crosses it, in lengths of the edge, and from the surface, Å.
constexpr double kRidgeReach = 0.7;
constexpr double kOffSurface = 0.05;

constexpr double kAside = 0.25;  // of the way to a corner: there the sheets are looked at

// Where the sheets that two points lie on meet, near the middle between them.
std::optional<Vec3> meeting_of_sheets(const SurfacePoint& a, const SurfacePoint& b, const SurfaceProjector& project) {
    const double cosine = dot(a.normal, b.normal);
    if (cosine > kCrease || cosine < -1.0 + 1e-6) return std::nullopt;
    const Vec3 middle = 0.5 * (a.position + b.position);
    const Vec3 place = meeting_of_planes(a.position, a.normal, b.position, b.normal, middle);
    if (squared_norm(place - middle) > kRidgeReach * kRidgeReach * squared_norm(b.position - a.position))
        return std::nullopt;
    SurfacePoint on_surface{place, a.normal, 0.0};
    project({&on_surface, 1});
    if (norm(on_surface.position - place) > kOffSurface) return std::nullopt;
    return on_surface.position;
}

}  // namespace

void insert_ridges(WorkingMesh& mesh, const SurfaceProjector& project, const Surroundings& left_out) {
    struct Crossing {
        VertexId from;
        VertexId to;
        Vec3 place;
    };
    const HalfEdges& edges = mesh.edges;
    std::vector<Crossing> crossings;
    mesh.for_each_edge([&](HalfEdge h) {
        const VertexId a = edges.origin(h);
        const VertexId b = edges.target(h);
        if (mesh.holds[a] == Hold::Frozen || mesh.holds[b] == Hold::Frozen) return;
        const auto place = meeting_of_sheets(mesh.points[a], mesh.points[b], project);
        if (place && !left_out.contain(*place)) crossings.push_back({a, b, *place});
    });
    // Edges are named by their ends, because a split gives neighbouring edges other half-edges.
    for (const auto& [from, to, place] : crossings) {
        const VertexId v = mesh.split(edges.between(from, to));
        mesh.points[v].position = place;
        mesh.holds[v] = Hold::Ridge;
    }
}

std::optional<Vec3> point_on_ridge(const Vec3& near, const std::array<Vec3, 2>& corners,
                                   const SurfaceProjector& project) {
    std::array<SurfacePoint, 2> sides;
    for (std::size_t k = 0; k < 2; ++k) sides[k].position = near + kAside * (corners[k] - near);
    project(sides);
    return meeting_of_sheets(sides[0], sides[1], project);
}

}  // namespace meniscus
