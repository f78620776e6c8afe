// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include "core/corner_numbers.h"
#include "core/parallel.h"
#include "measure/corner_sums.h"
#include "measure/surface_measures.h"
#include "measure/topology.h"
#include "measure/triangle_lanes.h"
#include "measure/triangle_survey.h"
#include "meniscus/errors.h"
#include "meniscus/mesh.h"
#include "mesh/components.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 8192;  // triangles or vertices per task: some tens of microseconds

bool all_below(std::span<const std::uint32_t> indices, std::size_t limit) {
    if (limit > std::numeric_limits<std::uint32_t>::max()) return true;
    const auto below = static_cast<std::uint32_t>(limit);
    return parallel_sum<std::size_t>(indices.size(), kChunk, [&](std::size_t begin, std::size_t end) {
               return std::size_t{
                   triangle_kernels().find_largest_index(indices.subspan(begin, end - begin)) < below ? 0U : 1U};
           }) == 0;
}

void check(const Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    if (!mesh.components.empty() && mesh.components.size() != n)
        throw UsageError("a mesh needs one component number per vertex, or none at all");
    if (!all_below(mesh.components, n)) throw UsageError("a component number is larger than the mesh has vertices");
    if (!all_below(all_corners(mesh.triangles), n))
        throw UsageError("a triangle names a vertex that the mesh does not have");
}

void add_topology(const Mesh& mesh, const MeshTopology& topology, MeshMeasures& measures) {
    measures.closed = topology.closed;
    measures.manifold = topology.manifold;
    measures.euler_characteristic = static_cast<std::int64_t>(mesh.vertices.size()) -
                                    static_cast<std::int64_t>(topology.edges) +
                                    static_cast<std::int64_t>(mesh.triangles.size());
}

}  // namespace

MeshMeasures measure_mesh(const Mesh& mesh) {
    check(mesh);
    const std::vector<std::uint32_t> found =
        mesh.components.empty() ? find_components(mesh).of_vertex : std::vector<std::uint32_t>();
    const std::span<const std::uint32_t> of_vertex = mesh.components.empty() ? found : mesh.components;
    MeshMeasures measures = TriangleSurvey(mesh, of_vertex, TriangleSurvey::Parts::LeftOut).measures(of_vertex);
    add_topology(mesh, examine_topology(mesh.vertices.size(), mesh.triangles), measures);
    return measures;
}

TriangleSurvey survey_surface(const Mesh& mesh, Creases creases, const TriangleLook& look) {
    check(mesh);
    if (mesh.normals.size() != mesh.vertices.size() || mesh.components.size() != mesh.vertices.size())
        throw UsageError("measures of a surface need one normal and one component number per vertex");
    using Parts = TriangleSurvey::Parts;
    return {mesh, mesh.components, creases == Creases::Sharp ? Parts::Creased : Parts::Smooth, look};
}

SurfaceMeasures measure_surface(Mesh& mesh, const TriangleSurvey& survey, Stars stars) {
    check(mesh);
    SurfaceMeasures measures{.mesh = survey.measures(mesh.components), .corrected = {}, .areas = {}};
    measures.corrected = extrapolate({measures.mesh.area, measures.mesh.volume}, survey.parts());
    renumber(measures.mesh.components, mesh.components);
    const auto topology = stars == Stars::Examined ? examine_topology : topology_of_manifold;
    parallel_both([&] { measures.areas = sums_at_corners(mesh.vertices.size(), mesh.triangles, survey.thirds()); },
                  [&] { add_topology(mesh, topology(mesh.vertices.size(), mesh.triangles), measures.mesh); });
    return measures;
}

double flat_area(const Mesh& mesh) {
    return parallel_sum<double>(mesh.triangles.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t t = begin; t < end; ++t) {
            const auto [a, b, c] = mesh.triangles[t];
            sum += 0.5 * norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
        }
        return sum;
    });
}

double longest_edge_of(const Mesh& mesh) {
    double squared = 0.0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            squared = std::max(squared, squared_norm(mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]));
    return std::sqrt(squared);
}

}  // namespace meniscus
