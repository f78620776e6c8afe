// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "geometry/accessible_surface.h"
#include "meniscus/errors.h"
#include "support/rounded.h"

namespace meniscus::testing {
namespace {

// Contact, toroidal and reentrant patches.
const Atoms kMolecule{{{0, 0, 0}, {1.5, 0.2, 0}, {2.4, 1.5, 0.3}, {4.1, -1.0, 2.2}}, {1.7, 1.55, 1.52, 1.8}};

TEST(SampleSurface, GivesTheDensityAskedFor) {
    const Surface surface = compute_surface(kMolecule);
    const Mesh points = sample_surface(surface, {.density = 2.5});
    EXPECT_EQ(points.vertices.size(), static_cast<std::size_t>(std::round(2.5 * surface.measures.area)));
    EXPECT_EQ(points.normals.size(), points.vertices.size());
    EXPECT_EQ(points.components.size(), points.vertices.size());
    EXPECT_EQ(points.shape_indices.size(), points.vertices.size());
    double area = 0.0;
    for (const float a : points.areas) area += double{a};
    EXPECT_NEAR(area, surface.measures.area, 1e-4 * area);
    EXPECT_TRUE(points.triangles.empty());
}

TEST(SampleSurface, PointsAreOnTheLevelSetWithItsNormalsAndCurvatures) {
    const Surface surface = compute_surface(kMolecule);
    const Mesh points = sample_surface(surface, {.density = 4.0});
    const AccessibleSurface exact(kMolecule, 1.4);
    for (std::size_t i = 0; i < points.vertices.size(); ++i) {
        const LevelSetSample at = surface.level_set->sample(points.vertices[i]);
        EXPECT_NEAR(at.value, 0.0, 1e-6);
        expect_rounded_from(points.normals[i], normalised(at.gradient), 1e-9);
        EXPECT_EQ(points.patches[i], exact.nearest(points.vertices[i]).patch);
        EXPECT_EQ(points.atoms[i], exact.nearest(points.vertices[i]).atom);
        const double mean = at.principal_curvatures().capped(2.0).mean();  // 1/spacing
        EXPECT_NEAR(double{points.mean_curvatures[i]}, mean, 1e-4);
    }
}

// Two balls that nearly touch: between them Newton's method can lead from one to the other, or nowhere.
TEST(SampleSurface, EveryPointLandsAlsoWhereSheetsNearlyTouch) {
    const Atoms atoms{{{0.02, 0.01, 0.03}, {3.7, 0.0, 0.1}, {1.7, 3.3, -0.2}, {1.9, 1.1, 3.1}}, {1.8, 1.8, 1.8, 1.8}};
    for (const Method method : {Method::Flow, Method::Direct, Method::Gaussian}) {
        const Surface surface = compute_surface(atoms, {.method = method, .probe = 0.3, .spacing = 0.6});
        const Mesh points = sample_surface(surface, {.density = 60.0});
        const AccessibleSurface exact(atoms, 0.3);
        const std::vector<double> values =
            surface.level_set ? surface.level_set->values(points.vertices) : signed_distance(exact, points.vertices);
        for (const double value : values) EXPECT_NEAR(value, 0.0, 1e-6);
    }
}

TEST(SampleSurface, PointsAreOnTheExactSurfaceWhereThereIsNoLevelSet) {
    const Surface surface = compute_surface(kMolecule, {.method = Method::Direct});
    const AccessibleSurface exact(kMolecule, 1.4);
    for (const Vec3& p : sample_surface(surface).vertices) EXPECT_NEAR(exact.nearest(p).signed_distance, 0.0, 1e-8);
}

TEST(SampleSurface, PointsOfLargeTrianglesAreOnTheSurfaceToo) {
    const Atoms ball{{{0.3, 0.1, 0.2}}, {6.0}};
    const Surface surface = compute_surface(ball, {.remesh = {.edge = 4.0}});
    const Mesh points = sample_surface(surface, {.density = 3.0});
    for (const Vec3& p : points.vertices) EXPECT_NEAR(norm(p - ball.centres[0]), 6.0, 0.02);
}

TEST(SampleSurface, IsTheSameForAnyNumberOfThreadsAndNotForAnotherSeed) {
    const Surface surface = compute_surface(kMolecule);
    const Mesh all = sample_surface(surface);
    EXPECT_TRUE(sample_surface(surface, {.threads = 1}).vertices == all.vertices);
    EXPECT_FALSE(sample_surface(surface, {.seed = 1}).vertices == all.vertices);
}

TEST(SampleSurface, OfNothingIsNothing) {
    const Surface surface = compute_surface(kMolecule, {.pieces = Pieces::Cavities});
    EXPECT_TRUE(sample_surface(surface).vertices.empty());
}

TEST(SampleSurface, RefusesDensitiesThatMakeNoSense) {
    const Surface surface = compute_surface(kMolecule, {.spacing = 1.0});
    for (const double density : {0.0, -1.0, std::nan(""), std::numeric_limits<double>::infinity()})
        EXPECT_THROW(sample_surface(surface, {.density = density}), UsageError);
    EXPECT_THROW(sample_surface(surface, {.density = 1e9}), LimitError);
    EXPECT_THROW(sample_surface(surface, {.threads = -1}), UsageError);
}

}  // namespace
}  // namespace meniscus::testing
