// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/surface_mesh.h"

#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "measure/surface_measures.h"
#include "mesh/components.h"
#include "project/finish_vertices.h"
#include "project/surface_projector.h"
#include "project/vertex_distances.h"
#include "remesh/first_look.h"
#include "remesh/mend_slivers.h"

namespace meniscus {
namespace {

constexpr std::size_t kTinyComponent = 8;  // triangles at most: those round a node

// Leaves the pieces that are wanted, with their numbers.
void keep_pieces(Mesh& mesh, Pieces pieces) {
    const std::vector<MeshComponent> components = label_components(mesh);
    std::vector<bool> keep(components.size());
    for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = (components[c].volume > 0.0) == (pieces == Pieces::Outer);
    keep_components(mesh, keep);
}

// Renumbers what is known of vertices, and finds it for those that moved.
void follow_changes(const MeshChanges& changes, const ProjectionTarget& target, Mesh& mesh,
                    VertexDistances& distances) {
    if (!changes.any()) return;
    renumber_entries(changes, mesh.atoms);
    renumber_entries(changes, mesh.patches);
    renumber_entries(changes, mesh.mean_curvatures);
    renumber_entries(changes, mesh.gaussian_curvatures);
    renumber_entries(changes, mesh.shape_indices);
    distances.renumber(changes);
    std::vector<VertexStart> starts;
    starts.reserve(changes.moved.size());
    for (const VertexId v : changes.moved) starts.push_back({v, mesh.vertices[v]});
    finish_again(target, starts, mesh, distances);
}

// A level set has rounded them.
Creases creases_of(const LevelSet* level_set) { return level_set != nullptr ? Creases::Rounded : Creases::Sharp; }

}  // namespace

DistanceSummary distance_of_vertices(const AccessibleSurface& accessible, const Mesh& mesh) {
    std::vector<float> distances;
    distances.reserve(mesh.vertices.size());
    for (const NearestFeature& at : nearest_features(accessible, mesh.vertices))
        distances.push_back(static_cast<float>(std::abs(at.signed_distance)));
    return VertexDistances(std::move(distances)).summarise();
}

TriangleSurvey survey_of(const Mesh& mesh, const LevelSet* level_set) {
    return survey_surface(mesh, creases_of(level_set));
}

SurfaceMesh mesh_surface(const AccessibleSurface& accessible, Mesh zero_set, const LevelSet* level_set,
                         const MeshingOptions& options) {
    Mesh mesh = std::move(zero_set);
    const bool has_all = options.pieces == Pieces::All;
    if (!has_all) keep_pieces(mesh, options.pieces);
    const ProjectionTarget target{accessible, level_set, options.spacing};
    std::optional<VertexDistances> found;
    parallel_both(  // one looks at triangles, the other at vertices
        [&] {
            if (has_all) mesh.components = pieces_by_first_vertex(mesh);
        },
        [&] { found = finish_vertices(target, mesh); });
    VertexDistances& distances = *found;
    const double edge = options.edge > 0.0 ? options.edge : options.spacing;
    const SliverOptions slivers{.edge = edge, .longest_edge = 2.0 * edge, .tiny_component = kTinyComponent};
    FirstLook look(mesh, slivers.smallest_angle_deg, slivers.shortest_edge());
    TriangleSurvey survey = survey_surface(mesh, creases_of(level_set),
                                           [&look](std::size_t first, std::span<const Triangle> triangles,
                                                   const TriangleLanes& lanes) { look.look(first, triangles, lanes); });
    const MeshChanges changes = mend_slivers(
        mesh, slivers, surface_projector(accessible, level_set, options.spacing, Curvatures::LeftOut), std::move(look));
    follow_changes(changes, target, mesh, distances);
    if (changes.dropped_components)
        survey = survey_of(mesh, level_set);
    else
        survey.update(mesh, mesh.components, changes.triangles);
    return {std::move(mesh), std::move(survey), distances.summarise()};
}

}  // namespace meniscus
