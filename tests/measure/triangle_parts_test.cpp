// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace meniscus {
namespace {

TEST(TriangleParts, CentroidsOfEqualPartsHaveTheTrianglesOwnForMean) {
    Mesh mesh;
    mesh.vertices = {{1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
    mesh.triangles = {{0, 1, 2}};
    for (const std::size_t n : {1U, 2U, 5U}) {
        std::vector<Vec3> points;
        for_each_part(mesh, mesh.triangles[0], n, [&](const Vec3& p) { points.push_back(p); });
        EXPECT_EQ(points.size(), n * n);
        Vec3 sum;
        for (const Vec3& p : points) {
            EXPECT_NEAR(p.x + p.y / 2 + p.z / 3, 1.0, 1e-15);  // in the plane
            EXPECT_GT(std::min({p.x, p.y, p.z}), 0.0);
            sum += (1.0 / static_cast<double>(points.size())) * p;
        }
        EXPECT_LT(norm(sum - Vec3{1.0 / 3, 2.0 / 3, 1.0}), 1e-14);
    }
    EXPECT_EQ(area_of(mesh, mesh.triangles[0]), 3.5);
}

}  // namespace
}  // namespace meniscus
