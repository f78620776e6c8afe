// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/surface_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "meniscus/surface.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

const Atoms kRidgedSpheres = ridged_spheres();

TEST(SurfaceMesh, VerticesOfTheExactDistanceLieOnTheSurface) {
    const AccessibleSurface exact(kRidgedSpheres, 1.4);
    for (const double spacing : {1.0, 0.5, 0.2}) {
        const Surface surface = compute_surface(kRidgedSpheres, {.method = Method::Direct, .spacing = spacing});
        std::vector<double> distances;
        for (const Vec3& v : surface.mesh.vertices) distances.push_back(std::abs(exact.nearest(v).signed_distance));
        std::sort(distances.begin(), distances.end());
        EXPECT_LT(distances[distances.size() * 9 / 10], 1e-9) << spacing;
        EXPECT_LT(distances.back(), 1e-6) << spacing << ": beside ridges";
        EXPECT_NEAR(distances.back(), surface.distance.max, 1e-12) << spacing;
    }
}

}  // namespace
}  // namespace meniscus::testing
