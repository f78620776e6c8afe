// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meniscus/errors.h"
#include "meniscus/tunnels.h"

namespace meniscus {
namespace {

// A path of points that place(t) and radius(t) give, t from 0 to 1.
template <class Place, class Radius>
TunnelPath path_of(const Place& place, const Radius& radius, int parts = 80) {
    TunnelPath path;
    for (int i = 0; i <= parts; ++i) {
        const double t = static_cast<double>(i) / parts;
        const Vec3 p = place(t);
        if (i > 0) path.length += norm(p - path.points.back().position);
        path.points.push_back({p, path.length, radius(t)});
    }
    return path;
}

TunnelPath straight(double radius) {
    return path_of(
        [](double t) {
            return Vec3{1.0 + 6.0 * t, 2.0 - 12.0 * t, 3.0 + 12.0 * t};
        },
        [=](double /*t*/) { return radius; });
}

TEST(Tube, OfAStraightPathIsACylinderWithHalfBalls) {
    constexpr double kRadius = 1.6;
    constexpr double kLength = 18.0;
    const double area = 2.0 * std::numbers::pi * kRadius * kLength + 4.0 * std::numbers::pi * kRadius * kRadius;
    const double volume = std::numbers::pi * kRadius * kRadius * (kLength + 4.0 / 3.0 * kRadius);
    double before = 1.0;
    for (const double edge : {0.4, 0.2, 0.1}) {
        const MeshMeasures measures = measure_mesh(tube_of(straight(kRadius), edge));
        EXPECT_TRUE(measures.closed);
        EXPECT_TRUE(measures.manifold);
        EXPECT_EQ(measures.euler_characteristic, 2);
        EXPECT_NEAR(measures.area, area, 0.02 * area);
        const double off = std::abs(measures.area - area) / area;
        EXPECT_LT(off, 0.4 * before);
        before = off;
        EXPECT_NEAR(measures.volume, volume, 0.04 * volume);  // positive: outwards
    }
    EXPECT_LT(before, 1e-3);
}

TEST(Tube, OfABentAndWideningPathIsOneClosedPieceThatFollowsIt) {
    const TunnelPath path = path_of(
        [](double t) {
            return Vec3{8.0 * std::cos(3.0 * t), 8.0 * std::sin(3.0 * t), 10.0 * t};
        },
        [](double t) { return 1.0 + t; }, 160);
    const Mesh tube = tube_of(path, 0.3);
    const MeshMeasures measures = measure_mesh(tube);
    EXPECT_TRUE(measures.closed);
    EXPECT_EQ(measures.euler_characteristic, 2);
    EXPECT_EQ(measures.components.size(), 1U);
    ASSERT_EQ(tube.normals.size(), tube.vertices.size());
    for (std::size_t v = 0; v < tube.vertices.size(); ++v) {
        double from_balls = 1e300;
        for (const PathPoint& p : path.points)
            from_balls = std::min(from_balls, norm(tube.vertices[v] - p.position) - p.radius);
        EXPECT_NEAR(from_balls, 0.0, 0.1);
    }
}

TEST(Tube, HasNormalsThatAreThoseOfItsTriangles) {
    const Mesh tube = tube_of(straight(1.5), 0.2);
    for (const Triangle& t : tube.triangles) {
        const Vec3 flat =
            normalised(cross(tube.vertices[t[1]] - tube.vertices[t[0]], tube.vertices[t[2]] - tube.vertices[t[0]]));
        for (const VertexId v : t) {
            const SmallVec3& n = tube.normals[v];
            EXPECT_GT(flat.x * n.x + flat.y * n.y + flat.z * n.z, 0.97);
        }
    }
}

TEST(Tube, OfASinglePointIsItsBall) {
    TunnelPath path;
    path.points.push_back({{1, 2, 3}, 0.0, 2.0});
    const MeshMeasures measures = measure_mesh(tube_of(path, 0.2));
    EXPECT_EQ(measures.euler_characteristic, 2);
    EXPECT_NEAR(measures.area, 16.0 * std::numbers::pi, 0.3);
}

TEST(Tube, RefusesWhatHasNoTube) {
    EXPECT_THROW(tube_of({}), UsageError);
    EXPECT_THROW(tube_of(straight(0.0)), UsageError);
    EXPECT_THROW(tube_of(straight(1.0), 0.0), UsageError);
}

}  // namespace
}  // namespace meniscus
