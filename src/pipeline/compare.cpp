// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/compare.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/parallel.h"
#include "core/requirements.h"
#include "measure/surface_distance.h"
#include "measure/weighted_distances.h"
#include "meniscus/errors.h"
#include "meniscus/measures.h"
#include "meniscus/mesh.h"
#include "meniscus/surface.h"
#include "meniscus/threads.h"
#include "mesh/merge_vertices.h"

namespace meniscus {
namespace {

// Squares and products of lengths must stay finite; also refuses what is no number.
bool is_in_reach(const Vec3& p) {
    constexpr double kReach = kFarthestCoordinate;
    return std::abs(p.x) <= kReach && std::abs(p.y) <= kReach && std::abs(p.z) <= kReach;
}

void check_reach(const Mesh& mesh) {
    if (!std::all_of(mesh.vertices.begin(), mesh.vertices.end(), is_in_reach))
        throw UsageError("a vertex that is not within 1e9 Å of the origin");
}

void check_mesh(const Mesh& mesh) {
    if (mesh.triangles.empty()) throw UsageError("a mesh without triangles cannot be compared");
    check_reach(mesh);
}

void check(const ComparedSurface& a, const ComparedSurface& b, const CompareOptions& options) {
    check_mesh(a.mesh);
    check_mesh(b.mesh);
    if (!(a.area > 0.0) || !(b.area > 0.0)) throw UsageError("a surface without area; there is nothing to compare");
    require_positive("points", options.density);
    check_threads(options.threads);
}

OneWayDistance summarise(const WeightedPoints& points, const std::vector<double>& distances,
                         const std::vector<double>& at_vertices) {
    WeightedDistances weighted(distances.size() + at_vertices.size());
    double signed_sum = 0.0;
    for (std::size_t i = 0; i < distances.size(); ++i) {
        weighted.set(i, std::abs(distances[i]), points.areas[i]);
        signed_sum += points.areas[i] * distances[i];
    }
    for (std::size_t v = 0; v < at_vertices.size(); ++v)  // where a coarse mesh is farthest off
        weighted.set(distances.size() + v, std::abs(at_vertices[v]), 0.0);
    const double area = std::accumulate(points.areas.begin(), points.areas.end(), 0.0);
    const DistanceSummary summary = std::move(weighted).summarise();
    return {summary.mean, summary.p99, summary.max, signed_sum / area, distances.size()};
}

// at_vertices   filled with the signed distances of the first surface's vertices
OneWayDistance distance_from(const ComparedSurface& from, const ComparedSurface& to, double density,
                             std::vector<double>& at_vertices) {
    const SurfaceDistance distance(to.mesh, to.exact ? &to.exact->accessible() : nullptr);
    WeightedPoints points = spread_over_triangles(from.mesh, density);
    if (from.exact) move_onto(from.exact->accessible(), points.points);
    at_vertices = distance(from.mesh.vertices);
    return summarise(points, distance(points.points), at_vertices);
}

std::size_t count_cavities(const std::vector<SurfaceComponent>& pieces) {
    return static_cast<std::size_t>(std::count_if(pieces.begin(), pieces.end(), [](const SurfaceComponent& piece) {
        return piece.kind == ComponentKind::Cavity;
    }));
}

void take_measures(const MeshMeasures& measures, ComparedSurface& surface) {
    surface.area = measures.area;
    surface.volume = measures.volume;
    surface.closed = measures.closed;
    surface.manifold = measures.manifold;
    for (const MeshComponent& piece : measures.components)
        if (piece.triangles > 0) ++(piece.volume < 0.0 ? surface.cavities : surface.outer_pieces);
}

}  // namespace

ComparedSurface mesh_to_compare(Mesh mesh) {
    check_reach(mesh);
    ComparedSurface surface{.mesh = std::move(mesh)};
    MeshMeasures measures = measure_mesh(surface.mesh);
    if (!measures.closed) {
        Mesh bare;
        bare.vertices = std::move(surface.mesh.vertices);
        bare.triangles = std::move(surface.mesh.triangles);
        surface.merged_vertices = merge_vertices(bare);
        surface.mesh = std::move(bare);
        measures = measure_mesh(surface.mesh);
    }
    take_measures(measures, surface);
    return surface;
}

ComparedSurface structure_to_compare(const Atoms& atoms, const StructureToCompare& options) {
    return exact_to_compare(ExactSurface(atoms, {.probe = options.probe}), options);
}

ComparedSurface exact_to_compare(ExactSurface exact, const StructureToCompare& options) {
    const SurfaceOptions direct{.method = Method::Direct, .spacing = options.spacing, .exact = true};
    Surface computed = meniscus::mesh(std::move(exact), direct, {.threads = options.threads});
    const Measures& measures = *computed.measured;
    ComparedSurface surface{.mesh = std::move(computed.mesh), .exact = computed.exact};
    surface.area = measures.totals.ses_area;
    surface.volume = measures.totals.ses_volume;
    surface.cavities = count_cavities(measures.components);
    surface.outer_pieces = measures.components.size() - surface.cavities;
    surface.closed = true;
    surface.manifold = true;
    return surface;
}

Comparison compare_surfaces(const ComparedSurface& a, const ComparedSurface& b, const CompareOptions& options) {
    check(a, b, options);
    const ThreadLimit limit(options.threads);
    Comparison comparison;
    std::vector<double> at_vertices;
    comparison.b_to_a = distance_from(b, a, options.density, at_vertices);
    comparison.a_to_b = distance_from(a, b, options.density, at_vertices);
    comparison.distances.assign(at_vertices.begin(), at_vertices.end());
    return comparison;
}

}  // namespace meniscus
