// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/openness.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "render/camera.h"
#include "render/sky_light.h"
#include "render/sky_reach.h"
#include "render/small_scenes.h"

namespace meniscus {
namespace {

using testing::blue_sphere;
using testing::ColouredMesh;

TEST(Openness, NothingHidesTheSkyFromABall) {
    const Mesh ball = blue_sphere({{0, 0, 0}, 3.0}, 0.5).mesh;
    for (const float share : openness(ball)) EXPECT_GT(share, 0.97F);
}

TEST(Openness, IsNearWhatPicturesSee) {
    ColouredMesh scene = blue_sphere({{0, 0, 0}, 3.0}, 0.4);
    append(scene, blue_sphere({{5.0, 0, 0}, 3.0}, 0.4));
    const RayScene rays(scene.mesh);
    const SkyLight sky({rays, scene.mesh, reach_of_sky(Camera(scene.mesh.vertices, {}))});
    const std::vector<float> shares = openness(scene.mesh);
    double sum = 0.0;
    for (std::size_t v = 0; v < shares.size(); ++v)
        sum += std::abs(double{shares[v]} - double{sky.at(static_cast<VertexId>(v))});
    EXPECT_LT(sum / static_cast<double>(shares.size()), 0.05);
    EXPECT_LT(*std::min_element(shares.begin(), shares.end()), 0.75F) << "there is shade between the balls";
}

}  // namespace
}  // namespace meniscus
