// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/depths.h"

#include <gtest/gtest.h>

#include <cmath>

#include "colours/small_meshes.h"
#include "meniscus/colours.h"

namespace meniscus {
namespace {

TEST(Depths, AreBelowTheSurfaceOfALargeProbe) {
    const auto [mesh, two] = testing::groove();
    // The probe that touches both atoms has its centre this far from their axis; the second point is below it.
    const double height = std::sqrt(12.0 * 12.0 - 4.0 * 4.0);
    const std::vector<double> depth = depths(mesh, ExactSurface(two.atoms));
    EXPECT_NEAR(depth[0], 0.0, 1e-9);
    EXPECT_NEAR(depth[1], std::hypot(height, 2.0) - kDepthProbe, 1e-9);
}

TEST(Depths, AreAVertexArrayThatColoursAreTakenFrom) {
    auto [mesh, two] = testing::groove();
    const VertexValues values = depth_values(mesh, ExactSurface(two.atoms));
    EXPECT_EQ(values.name, "depth");
    EXPECT_EQ(values.values[1], static_cast<float>(depths(mesh, ExactSurface(two.atoms))[1]));
    const auto own = colour_vertices(mesh, two, {.scheme = ColourScheme::Depth});
    mesh.values.push_back(values);
    EXPECT_EQ(colour_vertices(mesh, two, {.scheme = ColourScheme::Depth}), own);
    std::swap(mesh.values[0].values[0], mesh.values[0].values[1]);
    EXPECT_EQ(colour_vertices(mesh, two, {.scheme = ColourScheme::Depth})[0], own[1]);
}

}  // namespace
}  // namespace meniscus
