// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/finish_vertices.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "meniscus/surface.h"
#include "support/arrangements.h"
#include "support/rounded.h"

namespace meniscus::testing {
namespace {

const Atoms kRidged = ridged_spheres();

TEST(FinishVertices, LabelsAreThoseOfTheNearestFeatureWhereTheVertexHasComeToLie) {
    const AccessibleSurface exact(kRidged, 1.4);
    for (const Method method : {Method::Direct, Method::Flow})
        for (const double spacing : {1.0, 0.4}) {
            const Mesh mesh = compute_surface(kRidged, {.method = method, .spacing = spacing}).mesh;
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
                const NearestFeature at = exact.nearest(mesh.vertices[v]);
                EXPECT_EQ(mesh.atoms[v], at.atom);
                EXPECT_EQ(mesh.patches[v], at.patch);
                if (method == Method::Direct) {
                    expect_rounded_from(mesh.normals[v], at.normal, 1e-9);
                }
            }
        }
}

TEST(FinishVertices, NormalsOfTheFlowAreGradientsAtTheVertices) {
    const Surface surface = compute_surface(kRidged, {.spacing = 0.4});
    for (std::size_t v = 0; v < surface.mesh.vertices.size(); ++v) {
        const LevelSetSample at = surface.level_set->sample(surface.mesh.vertices[v]);
        EXPECT_LE(std::abs(at.value), 1e-7 * 0.4);
        EXPECT_EQ(surface.mesh.normals[v], to_small(normalised(at.gradient)));
    }
}

void expect_same_vertex(const Mesh& mesh, VertexId v, const Mesh& other, VertexId w) {
    EXPECT_EQ(mesh.vertices[v], other.vertices[w]);
    EXPECT_EQ(mesh.normals[v], other.normals[w]);
    EXPECT_EQ(mesh.atoms[v], other.atoms[w]);
    EXPECT_EQ(mesh.patches[v], other.patches[w]);
    EXPECT_EQ(mesh.mean_curvatures[v], other.mean_curvatures[w]);
    EXPECT_EQ(mesh.gaussian_curvatures[v], other.gaussian_curvatures[w]);
    EXPECT_EQ(mesh.shape_indices[v], other.shape_indices[w]);
}

// Of every array some entry is another one.
void expect_changed(const Mesh& mesh, const Mesh& before) {
    EXPECT_NE(mesh.vertices, before.vertices);
    EXPECT_NE(mesh.normals, before.normals);
    EXPECT_NE(mesh.atoms, before.atoms);
    EXPECT_NE(mesh.patches, before.patches);
    EXPECT_NE(mesh.mean_curvatures, before.mean_curvatures);
    EXPECT_NE(mesh.gaussian_curvatures, before.gaussian_curvatures);
    EXPECT_NE(mesh.shape_indices, before.shape_indices);
}

TEST(FinishAgain, SomeVerticesBecomeWhatTheyAreFromWhereTheyStartAndOthersStay) {
    const AccessibleSurface exact(kRidged, 1.4);
    const double spacing = 0.5;
    const Mesh before = compute_surface(kRidged, {.method = Method::Direct, .spacing = spacing}).mesh;
    std::vector<VertexStart> starts;
    Mesh alone;
    for (VertexId v = 1; v < before.vertices.size(); v += 3) {
        alone.vertices.push_back(before.vertices[v] + 0.1 * normalised({1, 2, 3}));
        starts.push_back({v, alone.vertices.back()});
    }
    Mesh mesh = before;
    VertexDistances distances(std::vector<float>(mesh.vertices.size(), 7.0F));
    const ProjectionTarget target{exact, nullptr, spacing};
    finish_again(target, starts, mesh, distances);
    const VertexDistances distances_alone = finish_vertices(target, alone);
    expect_changed(mesh, before);
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
        const bool again = v % 3 == 1;
        expect_same_vertex(mesh, v, again ? alone : before, again ? v / 3 : v);
        EXPECT_EQ(distances[v], again ? distances_alone[v / 3] : 7.0F);
        EXPECT_LT(std::abs(exact.nearest(mesh.vertices[v]).signed_distance), 1e-6);
    }
}

}  // namespace
}  // namespace meniscus::testing
