// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/even_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "cavities/choose_pieces.h"
#include "measure/surface_measures.h"
#include "meniscus/mesh_quality.h"
#include "remesh/narrow_handles.h"

namespace meniscus {
namespace {

constexpr int kSimplifyingRounds = 3;  // none has needed more than two

constexpr double kLongestPart = 0.3;  // Å: of the triangles that large ones are divided into to be measured

// Surfaces with room for some ten to some hundred vertices, from grids that are made even in no time.
constexpr double kLeastSurface = 5.0;  // edges²
constexpr double kSmallSurface = 110.0;
constexpr std::size_t kMostOfGrid = 40'000;  // vertices

// Lengths that are tried instead of the one asked for.
constexpr std::array kOtherLengths{0.98, 1.02, 0.96, 1.04, 0.94, 1.06, 0.92, 1.08, 0.9, 1.1, 0.88, 1.12};

// What small meshes are tried for. Areas are held against that under the mesh of the grid.
constexpr double kShortest = 0.6;  // of the length asked for
constexpr double kLongest = 1.5;
constexpr double kWantedWithin = 0.95;  // of all edges
constexpr double kWantedMedian = 45.0;  // of the smallest angles, degrees
constexpr double kWantedAngle = 20.0;
constexpr double kWantedDeviation = 0.003;  // relative

void project_vertices(const SurfaceProjector& project, std::span<Vec3> places, std::span<Vec3> normals) {
    std::vector<SurfacePoint> points(places.size());
    for (std::size_t i = 0; i < points.size(); ++i) points[i].position = places[i];
    project(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        places[i] = points[i].position;
        normals[i] = points[i].normal;
    }
}

double area_under(Mesh mesh, double edge, const SurfaceProjector& project) {
    std::vector<Vec3> normals(mesh.vertices.size());
    project_vertices(project, mesh.vertices, normals);
    mesh.normals.resize(normals.size());
    std::transform(normals.begin(), normals.end(), mesh.normals.begin(), to_small);
    return corrected_on_surface(mesh, edge, project).area;
}

double share_within(const Mesh& mesh, double shortest, double longest) {
    std::size_t within = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const double squared = squared_norm(mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]);
            if (squared >= shortest * shortest && squared <= longest * longest) ++within;
        }
    return static_cast<double>(within) / static_cast<double>(3 * mesh.triangles.size());
}

// Zero where a mesh is all that is wanted, else more the farther it is from that. Adaptive lengths may be any.
double shortcomings(const Mesh& even, const RemeshOptions& wanted, double area, const SurfaceProjector& project) {
    const double edge = wanted.edge;
    const double within = wanted.adaptive ? 1.0 : share_within(even, kShortest * edge, kLongest * edge);
    const MeshQuality quality = measure_quality(even);
    const auto missing = [](double least, double found, double unit) { return std::max(0.0, (least - found) / unit); };
    const double deviation = std::abs(area_under(even, edge, project) / area - 1.0);
    return missing(kWantedWithin, within, 0.05) + missing(kWantedMedian, quality.smallest_angles.p50, 5.0) +
           missing(kWantedAngle, quality.smallest_angles.min, 5.0) +
           missing(-kWantedDeviation, -deviation, kWantedDeviation);
}

bool is_small(const Mesh& zero_set, double edge) {
    if (zero_set.vertices.size() > kMostOfGrid) return false;
    const double room = flat_area(zero_set) / (edge * edge);
    return room > kLeastSurface && room < kSmallSurface;
}

Mesh best_of_many(const Mesh& zero_set, const RemeshOptions& wanted, const SurfaceProjector& project) {
    const double area = area_under(zero_set, kLongestPart, project);
    Mesh best = remesh(zero_set, wanted, project);
    double least = shortcomings(best, wanted, area, project);
    for (const double part : kOtherLengths) {
        if (least == 0.0) break;
        RemeshOptions other = wanted;
        other.edge *= part;
        Mesh even = remesh(zero_set, other, project);
        const double missing = shortcomings(even, wanted, area, project);
        if (missing >= least) continue;
        best = std::move(even);
        least = missing;
    }
    return best;
}

}  // namespace

Corners corners_of(const SurfaceOptions& options) {
    const RemeshOptions& even = options.remesh;
    const bool stay = even.is_on() && (even.keep_ridges || options.method == Method::Gaussian);
    return even.corners == Corners::Near && stay ? Corners::OnSurface : even.corners;
}

EvenMesh make_even(Mesh zero_set, const RemeshOptions& wanted, const SurfaceProjector& project) {
    EvenMesh even;
    if (!wanted.simplify_topology) {
        even.mesh = is_small(zero_set, wanted.edge) ? best_of_many(zero_set, wanted, project)
                                                    : remesh(zero_set, wanted, project);
        return even;
    }
    // Handles are too narrow for the triangles only where these are even; their ends are made even afterwards.
    even.simplified.pieces = drop_tiny_pieces(zero_set, wanted.edge);
    even.mesh = remesh(zero_set, wanted, project);
    for (int round = 0; round < kSimplifyingRounds; ++round) {
        const CutMesh cut = cut_narrow_handles(even.mesh, wanted.edge, project);
        if (cut.handles == 0) break;
        even.simplified.handles += cut.handles;
        even.mesh = remesh(cut.mesh, wanted, project);
    }
    return even;
}

CorrectedMeasures corrected_on_surface(const Mesh& mesh, double edge, const SurfaceProjector& project) {
    const auto move = [&project](std::span<Vec3> places, std::span<Vec3> normals) {
        project_vertices(project, places, normals);
    };
    // Edges are as long as they are asked for only as far as the molecule has room for them.
    const double longest = std::min(edge, longest_edge_of(mesh));
    int divisions = 1;
    while (std::ldexp(longest, -divisions) > kLongestPart) ++divisions;
    return corrected_measures(mesh, move, divisions);
}

}  // namespace meniscus
