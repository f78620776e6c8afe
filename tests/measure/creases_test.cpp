// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/creases.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <optional>

#include "measure/corrected.h"
#include "measure/triangle_sum.h"

namespace meniscus {
namespace {

constexpr double kSlope = 0x1.d21708p-2 / 0x1.c7e36p-1;  // 0.511: single precision holds its unit normals to 1e-14

// Half a roof whose ridge runs over the middles of two sides.
Mesh half_roof(float mean_curvature) {
    const Vec3 left = normalised({-kSlope, 0, 1});
    const Vec3 right = normalised({kSlope, 0, 1});
    Mesh mesh;
    mesh.vertices = {{-0.3, 0, 0}, {0.3, 0, 0}, {-0.3, 0.3, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.normals = {to_small(left), to_small(right), to_small(left)};
    mesh.mean_curvatures.assign(3, mean_curvature);
    mesh.gaussian_curvatures.assign(3, 0.0F);
    return mesh;
}

// What every instruction set finds over the only triangle of a mesh, if it is creased.
std::optional<TriangleSum> parts_over_crease(const Mesh& mesh) {
    std::optional<TriangleSum> parts;
    for (const TriangleKernels& kernels : supported_triangle_kernels()) {
        CreasedLanes lanes;
        const std::size_t lane = CreasedLanes::kCount - 1;
        for (std::size_t k = 0; k < 3; ++k) {
            const VertexId v = mesh.triangles[0][k];
            lanes.corners[k].point.set(lane, mesh.vertices[v]);
            lanes.corners[k].normal.set(lane, mesh.normals[v]);
            lanes.corners[k].mean_curvature[lane] = mesh.mean_curvatures[v];
            lanes.corners[k].gaussian_curvature[lane] = mesh.gaussian_curvatures[v];
        }
        const std::uint64_t creased = kernels.measure_over_creases(lanes, CreasedLanes::kCount);
        EXPECT_EQ(creased & ~(std::uint64_t{1} << lane), 0U);
        const TriangleSum found{lanes.two_areas[lane], lanes.six_volumes[lane]};
        if (kernels.instructions == "plain" && creased != 0) parts = found;
        EXPECT_EQ(creased != 0, parts.has_value());
        if (!parts) continue;
        EXPECT_EQ(found.two_areas, parts->two_areas);
        EXPECT_EQ(found.six_volumes, parts->six_volumes);
    }
    return parts;
}

TEST(Creases, PartsFollowTheRoof) {
    const Mesh mesh = half_roof(0.0F);
    const auto parts = parts_over_crease(mesh);
    ASSERT_TRUE(parts);
    EXPECT_NEAR(parts->two_areas, 0.18 * std::hypot(1.0, kSlope), 1e-12);
    EXPECT_GT(parts->six_volumes, 0.0);
}

TEST(Creases, AreNotWhereCurvaturesExplainTheTurn) {
    const Mesh mesh = half_roof(0.6F);  // principal curvatures 1.2 and 0 Å^-1
    EXPECT_FALSE(parts_over_crease(mesh));
}

TEST(Creases, OfTheOtherSenseAreNotExplainedByThem) {
    Mesh mesh = half_roof(0.6F);
    for (SmallVec3& normal : mesh.normals) normal.x = -normal.x;  // a valley
    const auto parts = parts_over_crease(mesh);
    ASSERT_TRUE(parts);
    EXPECT_NEAR(parts->two_areas, 0.18 * std::hypot(1.0, kSlope), 1e-12);
}

TEST(Creases, ReplacePartsOfTheTrianglesThatAreLookedAt) {
    Mesh mesh = half_roof(0.0F);
    mesh.triangles.assign(kLanes, mesh.triangles[0]);
    TriangleLanes lanes;
    triangle_kernels().gather(mesh.vertices.data(), mesh.normals.data(), mesh.triangles, {}, lanes);
    triangle_kernels().measure_with_parts(lanes);
    const TriangleLanes before = lanes;
    constexpr std::uint64_t kLookedAt = 0x8000'7070'0707'0011;
    follow_creases(mesh, mesh.triangles, kLookedAt, lanes);
    const double wanted = parts_of(lanes.two_areas[0], 0.18 * std::hypot(1.0, kSlope));
    for (std::size_t lane = 0; lane < kLanes; ++lane) {
        const bool looked_at = (kLookedAt >> lane & 1U) != 0;
        EXPECT_NEAR(lanes.parts_two_areas[lane], looked_at ? wanted : before.parts_two_areas[lane], 1e-7) << lane;
        EXPECT_EQ(lanes.parts_six_volumes[lane] != before.parts_six_volumes[lane], looked_at) << lane;
    }
}

TEST(Creases, AreKnownOnlyWithCurvatures) {
    Mesh mesh = half_roof(0.0F);
    EXPECT_TRUE(knows_creases(mesh));
    mesh.gaussian_curvatures.clear();
    EXPECT_FALSE(knows_creases(mesh));
}

}  // namespace
}  // namespace meniscus
