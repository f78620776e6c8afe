// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/finish_vertices.h"

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

TEST(FinishVertices, SomeOfAMeshAreReplacedByOthers) {
    const AccessibleSurface exact(kRidged, 1.4);
    Mesh mesh = compute_surface(kRidged, {.method = Method::Direct, .spacing = 0.5}).mesh;
    const Mesh before = mesh;
    std::vector<VertexId> places;
    Mesh again;
    for (VertexId v = 1; v < mesh.vertices.size(); v += 3) {
        places.push_back(v);
        again.vertices.push_back(mesh.vertices[v] + 0.1 * normalised({1, 2, 3}));
    }
    const VertexDistances distances = finish_vertices(exact, nullptr, 0.5, again);
    replace_vertices(mesh, places, again);
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
        if (v % 3 != 1) {
            EXPECT_EQ(mesh.vertices[v], before.vertices[v]);
            EXPECT_EQ(mesh.normals[v], before.normals[v]);
            continue;
        }
        const NearestFeature at = exact.nearest(mesh.vertices[v]);
        EXPECT_LT(std::abs(at.signed_distance), 1e-6);
        EXPECT_NEAR(distances[v / 3], std::abs(at.signed_distance), 1e-6);
        EXPECT_EQ(mesh.atoms[v], at.atom);
        EXPECT_EQ(mesh.patches[v], at.patch);
    }
}

}  // namespace
}  // namespace meniscus::testing
