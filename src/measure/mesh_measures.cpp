// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>

#include "measure/topology.h"
#include "meniscus/errors.h"
#include "meniscus/mesh.h"
#include "mesh/components.h"

namespace meniscus {
namespace {

void check(const Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    const auto is_below_n = [n](std::uint32_t i) { return i < n; };
    if (!mesh.components.empty() && mesh.components.size() != n)
        throw UsageError("a mesh needs one component number per vertex, or none at all");
    if (!std::all_of(mesh.components.begin(), mesh.components.end(), is_below_n))
        throw UsageError("a component number is larger than the mesh has vertices");
    for (const Triangle& t : mesh.triangles)
        if (!std::all_of(t.begin(), t.end(), is_below_n))
            throw UsageError("a triangle names a vertex that the mesh does not have");
}

// Square of the tangent of an angle below 90 degrees, as a fraction: compared without dividing.
struct SquaredTangent {
    double opposite;
    double adjacent;
    bool operator<(const SquaredTangent& b) const { return opposite * b.adjacent < b.opposite * adjacent; }
};

// Of the smallest corner of a triangle, which lies opposite the shortest side: the sides a, b at this corner have
// a · b = (a² + b² - shortest²) / 2, at least a sixth of the sum of all three squares.
SquaredTangent smallest_corner(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double ab = squared_norm(b - a);
    const double bc = squared_norm(c - b);
    const double ca = squared_norm(a - c);
    const double product = 0.5 * (ab + bc + ca) - std::min({ab, bc, ca});
    return {squared_norm(cross(b - a, c - a)), product * product};
}

double smallest_angle_deg(const Mesh& mesh) {
    if (mesh.triangles.empty()) return 0.0;
    SquaredTangent smallest{.opposite = 3.0, .adjacent = 1.0};  // no triangle has a larger smallest corner
    for (const auto& [a, b, c] : mesh.triangles) {
        const SquaredTangent corner = smallest_corner(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
        if (corner.adjacent == 0.0) return 0.0;  // a point
        if (corner < smallest) smallest = corner;
    }
    return std::atan(std::sqrt(smallest.opposite / smallest.adjacent)) * 180.0 / std::numbers::pi;
}

}  // namespace

MeshMeasures measure_mesh(const Mesh& mesh) {
    check(mesh);
    MeshMeasures measures;
    measures.components =
        mesh.components.empty() ? find_components(mesh).pieces : measure_components(mesh, mesh.components);
    for (const MeshComponent& piece : measures.components) {
        measures.area += piece.area;
        measures.volume += piece.volume;
    }
    const MeshTopology topology = examine_topology(mesh.vertices.size(), mesh.triangles);
    measures.closed = topology.closed;
    measures.manifold = topology.manifold;
    measures.euler_characteristic = static_cast<std::int64_t>(mesh.vertices.size()) -
                                    static_cast<std::int64_t>(topology.edges) +
                                    static_cast<std::int64_t>(mesh.triangles.size());
    measures.smallest_angle_deg = smallest_angle_deg(mesh);
    return measures;
}

}  // namespace meniscus
