// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "measure/corner_sums.h"
#include "measure/surface_measures.h"
#include "measure/topology.h"
#include "measure/triangle_survey.h"
#include "meniscus/errors.h"
#include "meniscus/mesh.h"
#include "mesh/components.h"

namespace meniscus {
namespace {

constexpr std::size_t kItemsPerTask = 8192;  // triangles or vertices per task: some tens of microseconds

void add_topology(const Mesh& mesh, const MeshTopology& topology, MeshMeasures& measures) {
    measures.closed = topology.closed;
    measures.manifold = topology.manifold;
    measures.euler_characteristic = static_cast<std::int64_t>(mesh.vertices.size()) -
                                    static_cast<std::int64_t>(topology.edges) +
                                    static_cast<std::int64_t>(mesh.triangles.size());
}

}  // namespace

MeshMeasures measure_mesh(const Mesh& mesh) {
    if (!mesh.components.empty() && mesh.components.size() != mesh.vertices.size())
        throw UsageError("a mesh needs one component number per vertex, or none at all");
    std::vector<std::uint32_t> found;
    if (mesh.components.empty()) {  // found along the triangles, before the survey looks at these
        check_corners(mesh, mesh.triangles);
        found = find_components(mesh).of_vertex;
    }
    const std::span<const std::uint32_t> of_vertex = mesh.components.empty() ? found : mesh.components;
    MeshMeasures measures = TriangleSurvey(mesh, of_vertex, TriangleSurvey::Parts::LeftOut).measures(of_vertex);
    add_topology(mesh, examine_topology(mesh.vertices.size(), mesh.triangles), measures);
    return measures;
}

TriangleSurvey survey_surface(const Mesh& mesh, Creases creases, const TriangleLook& look) {
    if (mesh.normals.size() != mesh.vertices.size() || mesh.components.size() != mesh.vertices.size())
        throw UsageError("measures of a surface need one normal and one component number per vertex");
    using Parts = TriangleSurvey::Parts;
    return {mesh, mesh.components, creases == Creases::Sharp ? Parts::Creased : Parts::Smooth, look};
}

SurfaceMeasures measure_surface(Mesh& mesh, const TriangleSurvey& survey, Stars stars) {
    const std::size_t n = mesh.vertices.size();
    SurfaceMeasures measures{.mesh = survey.measures(mesh.components), .corrected = {}, .areas = {}};
    measures.corrected = extrapolate({measures.mesh.area, measures.mesh.volume}, survey.parts());
    std::atomic<std::uint64_t> areas_of_all = 0;
    measures.areas = sums_at_corners(n, mesh.triangles, survey.thirds(), [&](std::span<const Triangle> some) {
        check_corners(mesh, some);
        if (stars == Stars::Trusted) areas_of_all += signed_areas(some);
    });
    add_topology(mesh,
                 stars == Stars::Trusted ? topology_of_manifold(n, mesh.triangles, areas_of_all)
                                         : examine_topology(n, mesh.triangles),
                 measures.mesh);
    renumber(measures.mesh.components, mesh.components);
    return measures;
}

double flat_area(const Mesh& mesh) {
    return parallel_sum<double>(mesh.triangles.size(), kItemsPerTask, [&](std::size_t begin, std::size_t end) {
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
