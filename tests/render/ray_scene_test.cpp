// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/ray_scene.h"

#include <gtest/gtest.h>

#include <optional>
#include <vector>

#include "support/shapes.h"

namespace meniscus {
namespace {

constexpr double kFar = 1e9;

TEST(RayScene, FindsTheNearestTriangleAndThePointInIt) {
    const Mesh mesh = testing::tetrahedron();
    const RayScene scene(mesh);
    const Ray ray{{0.1, 0.2, 5.0}, {0, 0, -1}};
    const auto hit = scene.first_hit(ray, kFar);
    ASSERT_TRUE(hit.has_value());
    const auto& [a, b, c] = mesh.triangles[hit->triangle];
    const Vec3 point =
        (1.0 - hit->u - hit->v) * mesh.vertices[a] + hit->u * mesh.vertices[b] + hit->v * mesh.vertices[c];
    EXPECT_LT(norm(point - (ray.origin + hit->distance * ray.direction)), 1e-5);
    EXPECT_NEAR(point.x, 0.1, 1e-5);
    EXPECT_GT(point.z, 0.0);
}

TEST(RayScene, ReachEndsARay) {
    const RayScene scene(testing::tetrahedron());
    EXPECT_FALSE(scene.first_hit({{0.1, 0.2, 5.0}, {0, 0, -1}}, 3.0).has_value());
    EXPECT_FALSE(scene.first_hit({{0.1, 0.2, 5.0}, {0, 0, 1}}, kFar).has_value());
    EXPECT_TRUE(scene.first_hit({{0.0, 0.0, 0.0}, {0, 0, 1}}, kFar).has_value()) << "seen from inside";
}

TEST(RayScene, WhatIsCutOffIsNotHit) {
    const Mesh mesh = testing::extracted_sphere({.centre = {}, .radius = 2.0}, 0.3);
    const RayScene lower = RayScene(mesh).cut({.point = {0, 0, 1}, .normal = {0, 0, 1}});
    const auto from_above = lower.first_hit({{0.1, 0.2, 5.0}, {0, 0, -1}}, kFar);
    ASSERT_TRUE(from_above.has_value());
    EXPECT_NEAR(from_above->distance, 7.0, 0.05);
    EXPECT_FALSE(lower.first_hit({{0.1, 0.2, 0.0}, {0, 0, 1}}, kFar).has_value());
    EXPECT_FALSE(lower.first_hit({{0.1, 0.2, 5.0}, {0, 0, -1}}, 3.5).has_value());
}

TEST(RayScene, RaysTogetherHitWhatEachHitsAlone) {
    const Mesh mesh = testing::extracted_sphere({.centre = {}, .radius = 2.0}, 0.3);
    for (const RayScene& scene : {RayScene(mesh), RayScene(mesh).cut({.point = {0, 0, 1}, .normal = {0, 0, 1}})})
        for (const std::size_t count : {std::size_t{1}, std::size_t{7}, RayScene::kTogether}) {
            std::vector<Ray> rays;
            for (std::size_t i = 0; i < count; ++i)
                rays.push_back({{0.3 * static_cast<double>(i) - 1.7, 0.1, 5.0}, {0, 0, -1}});
            std::vector<std::optional<RayHit>> hits(count, RayHit{});
            scene.first_hits(rays, 6.8, hits);
            for (std::size_t i = 0; i < count; ++i) {
                const auto alone = scene.first_hit(rays[i], 6.8);
                ASSERT_EQ(hits[i].has_value(), alone.has_value()) << i;
                if (!alone) continue;
                EXPECT_EQ(hits[i]->triangle, alone->triangle) << i;
                EXPECT_NEAR(hits[i]->distance, alone->distance, 1e-5) << i;
            }
        }
}

TEST(RayScene, FarFromTheOriginNothingIsLost) {
    const Vec3 far{1e5, -2e5, 3e5};
    Mesh mesh = testing::extracted_sphere({.centre = {}, .radius = 2.0}, 0.3);
    for (Vec3& v : mesh.vertices) v = v + far;
    const auto hit = RayScene(mesh).first_hit({far + Vec3{0.3, 0.4, 10}, {0, 0, -1}}, kFar);
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->distance, 10.0 - std::sqrt(4.0 - 0.25), 0.02);
}

TEST(RayScene, NoRayPassesThroughEdges) {
    const Mesh mesh = testing::extracted_sphere({.centre = {}, .radius = 2.0}, 0.3);
    const RayScene scene(mesh);
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 middle = 0.5 * (mesh.vertices[a] + mesh.vertices[b]);
        EXPECT_TRUE(scene.first_hit({{0, 0, 0}, normalised(middle)}, kFar).has_value());
        EXPECT_TRUE(scene.first_hit({{0, 0, 0}, normalised(mesh.vertices[c])}, kFar).has_value());
    }
}

}  // namespace
}  // namespace meniscus
