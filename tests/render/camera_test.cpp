// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/camera.h"

#include <gtest/gtest.h>

#include <vector>

namespace meniscus {
namespace {

constexpr Viewpoint kAlongZ{};

/// Where a ray passes the plane through the middle of the picture, at right angles to the view.
Vec3 at_depth(const Ray& ray, double z) { return ray.origin + (z - ray.origin.z) / ray.direction.z * ray.direction; }

TEST(Camera, PointsFillThePictureUpToItsMargin) {
    const std::vector<Vec3> points{{-2, -1, 0}, {8, 1, -4}};
    const Camera camera(points, {.width = 500, .height = 400, .viewpoint = kAlongZ});
    EXPECT_NEAR(camera.pixel_size(), 10.0 / (0.92 * 500), 1e-12);
    EXPECT_EQ(camera.depth_range(), 4.0);
    EXPECT_EQ(camera.depth({0, 0, 0}), 0.0);
    EXPECT_EQ(camera.depth({5, 1, -3}), 3.0);
    const Ray left = camera.ray(0.04 * 500, 200);
    EXPECT_NEAR(left.origin.x, -2.0, 1e-12);
    EXPECT_NEAR(left.origin.y, 0.0, 1e-12);
    EXPECT_GT(left.origin.z, 0.0);
    EXPECT_EQ(left.direction, (Vec3{0, 0, -1}));
}

TEST(Camera, HeightDecidesWhereItIsScarce) {
    const std::vector<Vec3> points{{0, -3, 0}, {1, 3, 0}};
    const Camera camera(points, {.width = 900, .height = 100, .viewpoint = kAlongZ});
    EXPECT_NEAR(camera.pixel_size(), 6.0 / 92.0, 1e-12);
    EXPECT_GT(camera.ray(450, 10).origin.y, camera.ray(450, 90).origin.y);
}

TEST(Camera, InPerspectiveEveryPointIsInThePicture) {
    const std::vector<Vec3> points{{-9, 0, 0}, {9, 0, 0}, {0, 5, 20}, {0, -5, -20}};
    const Camera camera(points,
                        {.width = 400, .height = 300, .viewpoint = kAlongZ, .projection = Projection::Perspective});
    const Ray upper_right = camera.ray(400, 0);
    for (const Vec3& p : points) {
        EXPECT_LT(std::abs(p.x), at_depth(upper_right, p.z).x);
        EXPECT_LT(std::abs(p.y), at_depth(upper_right, p.z).y);
        EXPECT_GT(upper_right.origin.z, p.z);
    }
    EXPECT_NEAR(norm(upper_right.direction), 1.0, 1e-12);
}

TEST(Camera, APointAloneIsFine) {
    const Camera camera(std::vector<Vec3>{{1, 2, 3}}, {});
    EXPECT_GT(camera.pixel_size(), 0.0);
    EXPECT_EQ(camera.depth_range(), 0.0);
}

}  // namespace
}  // namespace meniscus
