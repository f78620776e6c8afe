// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/ridges.h"

#include <optional>

namespace meniscus {
namespace {

// Over an edge of a grid of 0.5 Å the normal of a smooth surface turns by less than this, 50 degrees.
constexpr double kCrease = 0.64;

// How far a point of a crease may be from the edge that crosses it, in lengths of the edge, and from the surface, Å.
constexpr double kReach = 0.7;
constexpr double kOffSurface = 0.05;

// The point nearest to `from` on the tangent planes of both a and b.
Vec3 meeting_of_planes(const SurfacePoint& a, const SurfacePoint& b, const Vec3& from) {
    const double cosine = dot(a.normal, b.normal);
    const double off_a = dot(a.normal, a.position - from);
    const double off_b = dot(b.normal, b.position - from);
    const double scale = 1.0 / (1.0 - cosine * cosine);
    return from + (scale * (off_a - cosine * off_b)) * a.normal + (scale * (off_b - cosine * off_a)) * b.normal;
}

class RidgeFinder {
public:
    RidgeFinder(const WorkingMesh& mesh, const SurfaceProjector& project) : mesh_(mesh), project_(project) {}

    // Where an edge crosses a crease.
    std::optional<Vec3> crossing(HalfEdge h) const {
        if (is_frozen(mesh_.edges.origin(h)) || is_frozen(mesh_.edges.target(h))) return std::nullopt;
        const SurfacePoint& a = mesh_.points[mesh_.edges.origin(h)];
        const SurfacePoint& b = mesh_.points[mesh_.edges.target(h)];
        const double cosine = dot(a.normal, b.normal);
        if (cosine > kCrease || cosine < -1.0 + 1e-6) return std::nullopt;
        const Vec3 middle = 0.5 * (a.position + b.position);
        const Vec3 place = meeting_of_planes(a, b, middle);
        if (squared_norm(place - middle) > kReach * kReach * mesh_.squared_length(h)) return std::nullopt;
        SurfacePoint on_surface{place, a.normal, 0.0};
        project_({&on_surface, 1});
        if (norm(on_surface.position - place) > kOffSurface) return std::nullopt;
        return on_surface.position;
    }

private:
    bool is_frozen(VertexId v) const { return mesh_.holds[v] == Hold::Frozen; }

    const WorkingMesh& mesh_;
    const SurfaceProjector& project_;
};

}  // namespace

void insert_ridges(WorkingMesh& mesh, const SurfaceProjector& project, const Surroundings& left_out) {
    const RidgeFinder finder(mesh, project);
    std::vector<std::pair<HalfEdge, Vec3>> crossings;
    mesh.for_each_edge([&](HalfEdge h) {
        const auto place = finder.crossing(h);
        if (place && !left_out.contain(*place)) crossings.emplace_back(h, *place);
    });
    for (const auto& [h, place] : crossings) {
        const VertexId v = mesh.split(h);
        mesh.points[v].position = place;
        mesh.holds[v] = Hold::Ridge;
    }
}

}  // namespace meniscus
