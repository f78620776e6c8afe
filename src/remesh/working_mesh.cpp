// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/working_mesh.h"

namespace meniscus {
namespace {

constexpr double kFacing = 0.5;    // cosine of 60 degrees
constexpr double kSliver = 0.985;  // cosine of 10 degrees

}  // namespace

WorkingMesh::WorkingMesh(const Mesh& mesh, double edge)
    : edges(mesh.vertices.size(), mesh.triangles),
      points(mesh.vertices.size()),
      holds(mesh.vertices.size(), Hold::Free),
      targets(mesh.vertices.size(), edge) {
    for (std::size_t v = 0; v < points.size(); ++v) points[v].position = mesh.vertices[v];
}

WorkingMesh WorkingMesh::renumbered(std::span<const VertexId> order) const {
    Mesh mesh;
    mesh.triangles = edges.triangles(order);
    mesh.vertices.resize(order.size());
    WorkingMesh other(mesh, 0.0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        other.points[i] = points[order[i]];
        other.holds[i] = holds[order[i]];
        other.targets[i] = targets[order[i]];
    }
    return other;
}

double WorkingMesh::worst_round(VertexId v) const {
    double worst = 0.0;
    edges.for_each_leaving(v, [&](HalfEdge h) { worst = std::max(worst, badness(h)); });
    return worst;
}

bool WorkingMesh::faces_out(VertexId a, VertexId b, VertexId c) const {
    const Vec3 area = area_vector(at(a), at(b), at(c));
    const Vec3 normal = points[a].normal + points[b].normal + points[c].normal;
    const double along = dot(area, normal);
    return along > 0.0 && along * along > kFacing * kFacing * squared_norm(area) * squared_norm(normal);
}

bool WorkingMesh::all_face_out_round(VertexId v) const {
    bool all = true;
    edges.for_each_leaving(
        v, [&](HalfEdge h) { all = all && faces_out(edges.origin(h), edges.target(h), edges.opposite(h)); });
    return all;
}

double WorkingMesh::badness_after_collapse(HalfEdge h) const {
    const VertexId a = edges.origin(h);
    const VertexId b = edges.target(h);
    if (holds[a] == Hold::Frozen || holds[b] == Hold::Frozen) return kRefused;
    int ridges = 0;
    bool refused = false;
    double worst = 0.0;
    edges.for_each_leaving(a, [&](HalfEdge out) {
        if (refused) return;
        const VertexId x = edges.target(out);
        const VertexId y = edges.opposite(out);
        ridges += holds[x] == Hold::Ridge ? 1 : 0;
        if (x == b || y == b) return;
        const double longest = kLongEdge * target(b, x);
        refused = squared_norm(at(x) - at(b)) > longest * longest || (!faces_out(b, x, y) && faces_out(a, x, y)) ||
                  (turns_away(b, x) && !turns_away(a, x));
        worst = std::max(worst, badness(b, x, y));
    });
    // A ridge may only become shorter along itself, and its ends and forks stay.
    if (holds[a] == Hold::Ridge) refused = refused || holds[b] != Hold::Ridge || ridges != 2;
    return refused || (worst > kSliver && worst > worst_round(a)) ? kRefused : worst;
}

bool WorkingMesh::collapse(HalfEdge h, double at_most) {
    const HalfEdge g = edges.twin(h);
    const double forth = badness_after_collapse(h);
    const double back = badness_after_collapse(g);
    if (std::min(forth, back) > at_most) return false;
    const HalfEdge better = back < forth ? g : h;
    if (!edges.can_collapse(better)) return false;
    edges.collapse(better);
    return true;
}

WorkingMesh::Flip WorkingMesh::try_flip(HalfEdge h, Facing facing) const {
    const VertexId a = edges.origin(h);
    const VertexId b = edges.target(h);
    const VertexId c = edges.opposite(h);
    const VertexId d = edges.opposite(edges.twin(h));
    Flip flip{std::max(badness(a, b, c), badness(b, a, d)), std::max(badness(d, c, a), badness(c, d, b)), false};
    const auto frozen_at = [this](VertexId v) { return holds[v] == Hold::Frozen; };
    const bool frozen = frozen_at(a) || frozen_at(b) || frozen_at(c) || frozen_at(d);
    const bool bends = turns_away(c, d) && !turns_away(a, b);
    const bool faced_out = facing == Facing::Out || (faces_out(a, b, c) && faces_out(b, a, d));
    flip.allowed = !frozen && !bends && !is_ridge(h) && flip.after <= std::max(flip.before, kSliver) &&
                   (!faced_out || (faces_out(d, c, a) && faces_out(c, d, b))) && edges.can_flip(h);
    return flip;
}

VertexId WorkingMesh::split(HalfEdge h) {
    const VertexId a = edges.origin(h);
    const VertexId b = edges.target(h);
    const Vec3 normal = points[a].normal + points[b].normal;
    SurfacePoint middle;
    middle.position = 0.5 * (at(a) + at(b));
    middle.normal = squared_norm(normal) > 0.0 ? normalised(normal) : points[a].normal;
    const Hold hold = is_ridge(h) ? Hold::Ridge : Hold::Free;
    const double length = target(a, b);
    points.push_back(middle);
    holds.push_back(hold);
    targets.push_back(length);
    return edges.split(h);
}

}  // namespace meniscus
