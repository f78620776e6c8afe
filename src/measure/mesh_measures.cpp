// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/parallel.h"
#include "measure/topology.h"
#include "meniscus/errors.h"
#include "meniscus/mesh.h"
#include "mesh/components.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 8192;  // triangles or vertices per task: some tens of microseconds

std::uint32_t largest_of(std::uint32_t i) { return i; }
std::uint32_t largest_of(const Triangle& t) { return std::max({t[0], t[1], t[2]}); }

template <class T>
bool all_below(const std::vector<T>& indices, std::size_t limit) {
    const auto count_others = [&](std::size_t begin, std::size_t end) {
        std::size_t others = 0;
        for (std::size_t i = begin; i < end; ++i) others += largest_of(indices[i]) < limit ? 0 : 1;
        return others;
    };
    return parallel_sum<std::size_t>(indices.size(), kChunk, count_others) == 0;
}

void check(const Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    if (!mesh.components.empty() && mesh.components.size() != n)
        throw UsageError("a mesh needs one component number per vertex, or none at all");
    if (!all_below(mesh.components, n)) throw UsageError("a component number is larger than the mesh has vertices");
    if (!all_below(mesh.triangles, n)) throw UsageError("a triangle names a vertex that the mesh does not have");
}

// Square of the tangent of an angle below 90 degrees, as a fraction: compared without dividing.
struct SquaredTangent {
    double opposite = 3.0;  // of 60 degrees: no triangle has a larger smallest corner
    double adjacent = 1.0;

    bool operator<(const SquaredTangent& b) const { return opposite * b.adjacent < b.opposite * adjacent; }
    // The smaller of both.
    SquaredTangent& operator+=(const SquaredTangent& b) { return *this = b < *this ? b : *this; }
};

// Of the smallest corner of a triangle, which lies opposite the shortest side: the sides a, b at this corner have
// a · b = (a² + b² - shortest²) / 2, at least a sixth of the sum of all three squares. 0 for a point.
SquaredTangent smallest_corner(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double ab = squared_norm(b - a);
    const double bc = squared_norm(c - b);
    const double ca = squared_norm(a - c);
    const double product = 0.5 * (ab + bc + ca) - std::min(std::min(ab, bc), ca);
    const double adjacent = product * product;
    return {squared_norm(cross(b - a, c - a)), adjacent > 0.0 ? adjacent : 1.0};
}

double smallest_angle_deg(const Mesh& mesh) {
    if (mesh.triangles.empty()) return 0.0;
    const auto smallest_of = [&](std::size_t begin, std::size_t end) {
        SquaredTangent smallest;
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const SquaredTangent corner = smallest_corner(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
            if (corner < smallest) smallest = corner;
        }
        return smallest;
    };
    const auto smallest = parallel_sum<SquaredTangent>(mesh.triangles.size(), kChunk, smallest_of);
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
