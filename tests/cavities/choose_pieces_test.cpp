// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "cavities/choose_pieces.h"

#include <gtest/gtest.h>

#include <vector>

#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

const SurfaceProjector kStay = [](std::span<SurfacePoint>) {};

Mesh ball(const Vec3& centre, double radius) { return projected_sphere({centre, radius}, 0.25); }
Mesh cavity(const Vec3& centre, double radius) { return turned_inside_out(ball(centre, radius)); }

Mesh joined(const std::vector<Mesh>& parts) {
    Mesh mesh;
    for (const Mesh& part : parts) append(mesh, part);
    return mesh;
}

// A large ball with cavities of 32 and 4 Å³, an island of 2 Å³ in the larger one, and a ball of 1 Å³ beside it all.
Mesh hollow_ball() {
    return joined({ball({}, 5.0), cavity({-2, 0, 0}, 2.0), cavity({2, 0, 0}, 1.0), ball({-2, 0.5, 0}, 0.8),
                   ball({9, 0, 0}, 0.6)});
}

TEST(ChoosePieces, SmallCavitiesGo) {
    Mesh mesh = hollow_ball();
    const DroppedPieces dropped = drop_small_cavities(mesh, 10.0, kStay);
    EXPECT_EQ(dropped.cavities, 1u);
    EXPECT_EQ(dropped.islands, 0u);
    const Mesh rest = joined({ball({}, 5.0), cavity({-2, 0, 0}, 2.0), ball({-2, 0.5, 0}, 0.8), ball({9, 0, 0}, 0.6)});
    EXPECT_EQ(mesh.vertices, rest.vertices);
    EXPECT_EQ(mesh.triangles, rest.triangles);
}

TEST(ChoosePieces, IslandsGoWithTheirCavityAndOuterPiecesStay) {
    Mesh mesh = hollow_ball();
    const DroppedPieces dropped = drop_small_cavities(mesh, 1000.0, kStay);
    EXPECT_EQ(dropped.cavities, 2u);
    EXPECT_EQ(dropped.islands, 1u);
    const Mesh rest = joined({ball({}, 5.0), ball({9, 0, 0}, 0.6)});
    EXPECT_EQ(mesh.vertices, rest.vertices);
    EXPECT_EQ(mesh.triangles, rest.triangles);
}

TEST(ChoosePieces, BesideACavityIsNotWithinIt) {
    // In the corner of the cavity's box.
    Mesh mesh = joined({cavity({}, 2.0), ball({1.5, 1.5, 1.5}, 0.3)});
    const DroppedPieces dropped = drop_small_cavities(mesh, 100.0, kStay);
    EXPECT_EQ(dropped.cavities, 1u);
    EXPECT_EQ(dropped.islands, 0u);
    EXPECT_EQ(mesh.vertices, ball({1.5, 1.5, 1.5}, 0.3).vertices);
}

TEST(ChoosePieces, VolumesAreThoseOnTheSurface) {
    // The projector moves the walls from 1 to 1.2 Å: 4.2 to 7.2 Å³.
    const SurfaceProjector grow = [](std::span<SurfacePoint> points) {
        for (SurfacePoint& point : points) point.position = 1.2 * normalised(point.position);
    };
    const Mesh before = cavity({}, 1.0);
    for (const double least : {6.0, 8.0}) {
        Mesh mesh = before;
        EXPECT_EQ(drop_small_cavities(mesh, least, grow).cavities, least == 6.0 ? 0u : 1u);
        EXPECT_EQ(mesh.vertices, least == 6.0 ? before.vertices : std::vector<Vec3>{})
            << "the mesh itself is not moved";
    }
}

TEST(ChoosePieces, NothingToDropLeavesTheMesh) {
    Mesh mesh = hollow_ball();
    EXPECT_EQ(drop_small_cavities(mesh, 0.1, kStay).cavities, 0u);
    EXPECT_EQ(mesh.vertices, hollow_ball().vertices);
    Mesh none;
    EXPECT_EQ(drop_small_cavities(none, 10.0, kStay).cavities, 0u);
    EXPECT_EQ(drop_tiny_pieces(none, 10.0), 0u);
}

TEST(ChoosePieces, PiecesSmallerThanAnEdgeVanish) {
    Mesh mesh = hollow_ball();
    EXPECT_EQ(drop_tiny_pieces(mesh, 1.9), 2u);
    EXPECT_EQ(measure_mesh(mesh).components.size(), 3u);
    EXPECT_EQ(drop_tiny_pieces(mesh, 1.9), 0u);
    EXPECT_EQ(drop_tiny_pieces(mesh, 100.0), 2u) << "the largest outer piece stays";
    EXPECT_EQ(mesh.vertices, ball({}, 5.0).vertices);
}

}  // namespace
}  // namespace meniscus::testing
