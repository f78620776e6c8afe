// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "geometry/local_features.h"
#include "measure/vertex_areas.h"
#include "mesh/components.h"
#include "mesh/extract.h"

namespace meniscus {
namespace {

constexpr std::size_t kGrain = 1024;  // vertices per task

void label_and_choose(Mesh& mesh, Pieces pieces) {
    const std::vector<MeshComponent> components = label_components(mesh);
    if (pieces == Pieces::All) return;
    std::vector<bool> keep(components.size());
    for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = (components[c].volume > 0.0) == (pieces == Pieces::Outer);
    keep_components(mesh, keep);
}

void resize_curvatures(Mesh& mesh) {
    mesh.mean_curvatures.resize(mesh.vertices.size());
    mesh.gaussian_curvatures.resize(mesh.vertices.size());
    mesh.shape_indices.resize(mesh.vertices.size());
}

// A grid cannot tell more than 1/spacing, and at cusps of the exact surface there is no limit.
void set_curvatures(Mesh& mesh, std::size_t v, const PrincipalCurvatures& k, double spacing) {
    const PrincipalCurvatures capped = k.capped(1.0 / spacing);
    mesh.mean_curvatures[v] = static_cast<float>(capped.mean());
    mesh.gaussian_curvatures[v] = static_cast<float>(capped.gaussian());
    mesh.shape_indices[v] = static_cast<float>(capped.shape_index());
}

void project_onto_level_set(const LevelSet& level_set, Mesh& mesh) {
    mesh.normals.resize(mesh.vertices.size());
    resize_curvatures(mesh);
    parallel_for(mesh.vertices.size(), kGrain, [&](std::size_t v) {
        mesh.vertices[v] = level_set.project(mesh.vertices[v]);
        const LevelSetSample at = level_set.sample(mesh.vertices[v]);
        mesh.normals[v] = squared_norm(at.gradient) > 0.0 ? normalised(at.gradient) : Vec3{0.0, 0.0, 1.0};
        set_curvatures(mesh, v, at.principal_curvatures(), level_set.spacing());
    });
}

// Next to ridges the distance is a lower bound, so a step can fall short: a few are taken.
void project_onto_exact_surface(const AccessibleSurface& accessible, Mesh& mesh) {
    constexpr int kSteps = 3;
    for (int step = 0; step < kSteps; ++step) {
        const std::vector<NearestFeature> features = nearest_features(accessible, mesh.vertices);
        parallel_for(mesh.vertices.size(), kGrain, [&](std::size_t v) {
            mesh.vertices[v] = mesh.vertices[v] - features[v].signed_distance * features[v].normal;
        });
    }
}

DistanceSummary summarise(std::vector<double>& distances) {
    if (distances.empty()) return {};
    DistanceSummary summary;
    for (const double d : distances) summary.mean += d;
    summary.mean /= static_cast<double>(distances.size());
    const auto p99 = distances.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), p99, distances.end());
    summary.p99 = *p99;
    summary.max = *std::max_element(p99, distances.end());
    return summary;
}

// Normals and curvatures of the exact surface.
void attach_shape(const std::vector<NearestFeature>& features, double spacing, Mesh& mesh) {
    mesh.normals.resize(features.size());
    resize_curvatures(mesh);
    parallel_for(features.size(), kGrain, [&](std::size_t v) {
        mesh.normals[v] = features[v].normal;
        const PrincipalCurvatures k = principal_curvatures(features[v].mean_curvature, features[v].gaussian_curvature);
        set_curvatures(mesh, v, k, spacing);
    });
}

// Labels the vertices by their nearest features; returns their distances.
DistanceSummary attach(const std::vector<NearestFeature>& features, Mesh& mesh) {
    mesh.atoms.resize(features.size());
    mesh.patches.resize(features.size());
    std::vector<double> distances(features.size());
    for (std::size_t v = 0; v < features.size(); ++v) {
        mesh.atoms[v] = features[v].atom;
        mesh.patches[v] = features[v].patch;
        distances[v] = std::abs(features[v].signed_distance);
    }
    return summarise(distances);
}

}  // namespace

SurfaceMesh mesh_surface(const AccessibleSurface& accessible, const BlockGrid& grid, std::span<const float> values,
                         const LevelSet* level_set, Pieces pieces) {
    SurfaceMesh result{extract_zero_set(grid, values), {}};
    label_and_choose(result.mesh, pieces);
    if (level_set != nullptr)
        project_onto_level_set(*level_set, result.mesh);
    else
        project_onto_exact_surface(accessible, result.mesh);
    const std::vector<NearestFeature> features = nearest_features(accessible, result.mesh.vertices);
    if (level_set == nullptr) attach_shape(features, grid.spacing(), result.mesh);
    result.distance = attach(features, result.mesh);
    result.mesh.areas = vertex_areas(result.mesh);
    return result;
}

}  // namespace meniscus
