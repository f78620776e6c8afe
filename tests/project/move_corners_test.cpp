// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/move_corners.h"

#include <gtest/gtest.h>

#include <cmath>

#include "geometry/accessible_surface.h"
#include "measure/mesh_distance.h"
#include "meniscus/errors.h"
#include "meniscus/mesh_quality.h"
#include "meniscus/surface.h"
#include "pipeline/even_mesh.h"
#include "project/surface_projector.h"
#include "support/mesh_checks.h"

namespace meniscus::testing {
namespace {

// Two balls and the torus between them: of all curvatures.
class MovedCorners : public ::testing::Test {
protected:
    const Atoms atoms_{{{-1.3, 0.2, 0.0}, {1.4, 0.0, 0.1}}, {1.8, 1.6}};
    const AccessibleSurface exact_{atoms_, 1.4};

    SurfaceOptions options(Corners corners, double edge) const {
        SurfaceOptions options{.method = Method::Direct};
        options.remesh.edge = edge;
        options.remesh.corners = corners;
        return options;
    }
    Mesh mesh(Corners corners, double edge) const { return compute_surface(atoms_, options(corners, edge)).mesh; }
    double distance_of_vertices(const Mesh& mesh) const {
        double sum = 0.0;
        for (const Vec3& v : mesh.vertices) sum += std::abs(exact_.nearest(v).signed_distance);
        return sum / static_cast<double>(mesh.vertices.size());
    }
};

TEST_F(MovedCorners, AreAsNearAsTheMeanDistanceAllows) {
    for (const double edge : {0.5, 0.7, 1.0}) {
        const Mesh on_surface = mesh(Corners::OnSurface, edge);
        const Mesh near = mesh(Corners::Near, edge);
        const Mesh balanced = mesh(Corners::Balanced, edge);
        expect_closed_manifold(near);
        EXPECT_LT(distance_of_vertices(on_surface), 1e-6);
        EXPECT_GT(distance_of_vertices(near), 1e-3);
        EXPECT_LT(distance_of_vertices(near), distance_of_vertices(balanced));
        const double wanted = kDistancePerSquareEdge * edge * edge;
        EXPECT_GT(mean_distance_to_exact(on_surface, exact_, 1), 1.3 * wanted) << edge;
        EXPECT_LE(mean_distance_to_exact(near, exact_, 1), wanted) << edge;
        EXPECT_GT(mean_distance_to_exact(near, exact_, 1), 0.9 * wanted) << edge;
        EXPECT_LT(mean_distance_to_exact(balanced, exact_, 1), 0.8 * wanted) << edge;
        EXPECT_EQ(near.triangles, balanced.triangles);
    }
}

TEST_F(MovedCorners, StayWhereTrianglesAreNearEnough) {
    const Atoms ball{{{}}, {12.0}};  // 1/8r of edge², times 0.85²
    const AccessibleSurface exact(ball, 1.4);
    Mesh mesh = compute_surface(ball, options(Corners::OnSurface, 1.0)).mesh;
    const Mesh before = mesh;
    const SurfaceProjector project = surface_projector(exact, nullptr, 0.5, Curvatures::LeftOut);
    EXPECT_FALSE(move_corners(mesh, {.edge = 1.0, .corners = Corners::Near}, exact, project));
    EXPECT_EQ(mesh.vertices, before.vertices);
    EXPECT_TRUE(move_corners(mesh, {.edge = 1.0, .corners = Corners::Balanced}, exact, project));
    EXPECT_NE(mesh.vertices, before.vertices);
}

TEST_F(MovedCorners, StayOnRidgesAndEnvelopesUnlessTheyAreToBeBalanced) {
    EXPECT_EQ(corners_of(options(Corners::Near, 1.0)), Corners::Near);
    for (const Corners corners : {Corners::Near, Corners::Balanced}) {
        SurfaceOptions ridges = options(corners, 1.0);
        ridges.remesh.keep_ridges = true;
        SurfaceOptions envelope = options(corners, 1.0);
        envelope.method = Method::Gaussian;
        const Corners wanted = corners == Corners::Near ? Corners::OnSurface : corners;
        EXPECT_EQ(corners_of(ridges), wanted);
        EXPECT_EQ(corners_of(envelope), wanted);
    }
}

TEST_F(MovedCorners, AreThoseOfEvenTriangles) {
    const Surface grid = compute_surface(atoms_, options(Corners::Near, 0.0));
    EXPECT_LT(distance_of_vertices(grid.mesh), 1e-6);
    EXPECT_EQ(grid.options.remesh.corners, Corners::Near);  // or the same options would be refused
    for (const Corners corners : {Corners::OnSurface, Corners::Balanced})
        EXPECT_THROW(compute_surface(atoms_, options(corners, 0.0)), UsageError);
}

}  // namespace
}  // namespace meniscus::testing
