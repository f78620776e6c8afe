// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/corrected.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "measure/lanes.h"
#include "measure/triangle_lanes.h"
#include "measure/triangle_sum.h"
#include "meniscus/errors.h"
#include "mesh/local_corners.h"
#include "simd/tangent_planes.h"

namespace meniscus {
namespace {

constexpr std::size_t kTrianglesPerBatch = 4096;  // triangles per batch: some thousand middles, a few hundred kB

// Sums over triangles and over the four parts of each.
struct CorrectedSums {
    TriangleSum whole;
    TriangleSum parts;

    CorrectedSums& operator+=(const CorrectedSums& b) {
        whole += b.whole;
        parts += b.parts;
        return *this;
    }
};

CorrectedMeasures corrected_by(const CorrectedSums& sums) {
    return extrapolate({sums.whole.two_areas / 2.0, sums.whole.six_volumes / 6.0},
                       {sums.parts.two_areas / 2.0, sums.parts.six_volumes / 6.0});
}

// Volumes are taken from a vertex of the mesh, so that they do not lose digits far from the origin.
Vec3 reference_point(const Mesh& mesh) { return mesh.vertices.empty() ? Vec3{} : mesh.vertices.front(); }

void need_normals(const Mesh& mesh) {
    if (mesh.normals.size() != mesh.vertices.size())
        throw UsageError("curvature-corrected measures need one normal per vertex");
}

// Numbers the sides of one batch of triangles in the order of their first appearance: an open-addressing hash table.
class SideNumbers {
public:
    explicit SideNumbers(std::size_t triangles) : slots_(std::bit_ceil(6 * triangles), kFree) {
        sides_.reserve(3 * triangles);
    }

    std::uint32_t number_of(VertexId a, VertexId b) {
        const Side side = std::minmax(a, b);
        const std::size_t mask = slots_.size() - 1;
        std::size_t slot = (side.first * 0x9E3779B97F4A7C15ULL ^ side.second * 0xC2B2AE3D27D4EB4FULL) >> 20U & mask;
        while (slots_[slot] != kFree && sides_[slots_[slot]] != side) slot = (slot + 1) & mask;
        if (slots_[slot] == kFree) {
            slots_[slot] = static_cast<std::uint32_t>(sides_.size());
            sides_.push_back(side);
        }
        return slots_[slot];
    }

    using Side = std::pair<VertexId, VertexId>;
    const std::vector<Side>& sides() const { return sides_; }

private:
    static constexpr std::uint32_t kFree = 0xffffffffU;
    std::vector<std::uint32_t> slots_;
    std::vector<Side> sides_;
};

// Some of a mesh's triangles, with vertices of their own.
struct Batch {
    std::vector<Vec3> points;
    std::vector<Vec3> normals;
    std::vector<Triangle> triangles;

    Batch(const Mesh& mesh, std::span<const Triangle> of) {
        std::vector<VertexId> all;
        all.reserve(3 * of.size());
        for (const Triangle& t : of) all.insert(all.end(), t.begin(), t.end());
        const LocalCorners corners(std::move(all));
        points.reserve(corners.vertices().size());
        normals.reserve(corners.vertices().size());
        for (const VertexId v : corners.vertices()) {
            points.push_back(mesh.vertices[v]);
            normals.push_back(mesh.normals[v]);
        }
        triangles.reserve(of.size());
        for (const Triangle& t : of) triangles.push_back(corners.local(t));
    }

    // Splits every triangle into four at the projected middles of its sides.
    void divide(const Projector& project) {
        SideNumbers numbers(triangles.size());
        std::vector<Triangle> parts;
        parts.reserve(4 * triangles.size());
        const auto corners = static_cast<VertexId>(points.size());
        for (const auto& [a, b, c] : triangles) {
            const VertexId ab = corners + numbers.number_of(a, b);
            const VertexId bc = corners + numbers.number_of(b, c);
            const VertexId ca = corners + numbers.number_of(c, a);
            parts.insert(parts.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
        }
        points.reserve(points.size() + numbers.sides().size());
        for (const auto& [a, b] : numbers.sides())
            points.push_back(arc_middle(points[a], normals[a], points[b], normals[b]));
        normals.resize(points.size());
        project(std::span(points).subspan(corners), std::span(normals).subspan(corners));
        triangles = std::move(parts);
    }

    // Triangles that face away from the surface lie over others twice, and are taken off once.
    TriangleSum sum(const Vec3& origin) const {
        TriangleSum sum;
        for (const auto& [a, b, c] : triangles) {
            const Vec3 area = cross(points[b] - points[a], points[c] - points[a]);
            const bool is_folded = dot(area, normals[a] + normals[b] + normals[c]) < 0.0;
            sum.two_areas += is_folded ? -norm(area) : norm(area);
            sum.six_volumes += dot(points[a] - origin, area);
        }
        return sum;
    }
};

CorrectedSums projected_sums(const Mesh& mesh, const Projector& project, int divisions,
                             std::span<const Triangle> triangles) {
    const Vec3 origin = reference_point(mesh);
    Batch batch(mesh, triangles);
    for (int division = 1; division < divisions; ++division) batch.divide(project);
    CorrectedSums sums{batch.sum(origin), {}};
    batch.divide(project);
    sums.parts = batch.sum(origin);
    return sums;
}

CorrectedSums estimated_sums(const Mesh& mesh, std::size_t begin, std::size_t end) {
    const Vec3 origin = reference_point(mesh);
    TriangleLanes lanes;
    CorrectedSums sums;
    for (std::size_t first = begin; first < end; first += kLanes) {
        const auto triangles = std::span(mesh.triangles).subspan(first, std::min(kLanes, end - first));
        triangle_kernels().gather(mesh.vertices.data(), mesh.normals.data(), triangles, origin, lanes);
        triangle_kernels().measure_with_parts(lanes);
        for (std::size_t lane = 0; lane < triangles.size(); ++lane)
            sums += CorrectedSums{{lanes.two_areas[lane], lanes.six_volumes[lane]},
                                  {lanes.parts_two_areas[lane], lanes.parts_six_volumes[lane]}};
    }
    return sums;
}

}  // namespace

CorrectedMeasures extrapolate(const CorrectedMeasures& whole, const CorrectedMeasures& parts) {
    return {.area = parts.area + (parts.area - whole.area) / 3.0,
            .volume = parts.volume + (parts.volume - whole.volume) / 3.0};
}

CorrectedMeasures corrected_measures(const Mesh& mesh, const Projector& project, int divisions) {
    need_normals(mesh);
    const std::size_t chunk = kTrianglesPerBatch >> std::min(2 * (divisions - 1), std::countr_zero(kTrianglesPerBatch));
    return corrected_by(
        parallel_sum<CorrectedSums>(mesh.triangles.size(), chunk, [&](std::size_t begin, std::size_t end) {
            return projected_sums(mesh, project, divisions, std::span(mesh.triangles).subspan(begin, end - begin));
        }));
}

CorrectedMeasures corrected_measures(const Mesh& mesh) {
    need_normals(mesh);
    return corrected_by(parallel_sum<CorrectedSums>(
        mesh.triangles.size(), kTrianglesPerBatch,
        [&](std::size_t begin, std::size_t end) { return estimated_sums(mesh, begin, end); }));
}

}  // namespace meniscus
