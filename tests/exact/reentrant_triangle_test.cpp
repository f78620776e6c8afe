// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/reentrant_triangle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace meniscus {
namespace {

Atoms random_cluster(std::size_t count, double extent, double radius) {
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> within(0.0, extent);
    Atoms atoms;
    for (std::size_t i = 0; i < count; ++i) {
        atoms.centres.push_back({within(random), within(random), within(random)});
        atoms.radii.push_back(radius);
    }
    return atoms;
}

TEST(ReentrantTriangle, OfACornerOfACubeIsAnOctant) {
    // A probe in the origin touches three atoms on the axes.
    const AccessibleSurface surface({{{3, 0, 0}, {0, 3, 0}, {0, 0, 3}}, {1.6, 1.6, 1.6}}, 1.4);
    const auto& vertices = surface.data().vertices;
    const auto here = std::find_if(vertices.begin(), vertices.end(),
                                   [](const SasVertex& vertex) { return norm(vertex.position) < 1e-6; });
    ASSERT_NE(here, vertices.end());
    const ReentrantTriangle triangle(surface.data(), *here);
    EXPECT_NEAR(triangle.solid_angle, 0.5 * std::numbers::pi, 1e-8);
    for (const double length : triangle.lengths) EXPECT_NEAR(length, 0.5 * std::numbers::pi, 1e-8);
    EXPECT_NEAR(triangle.cos_farthest, std::sqrt(1.0 / 3.0), 1e-8);
    EXPECT_TRUE(triangle.is_wide());
    const Vec3 inside = normalised({1, 1, 1});
    EXPECT_FALSE(triangle.is_missed_by(inside, 0.9));
    EXPECT_FALSE(triangle.is_missed_by(-inside, -0.8)) << "a cap that leaves little more than the triangle free";
    EXPECT_TRUE(triangle.is_missed_by(-inside, 0.1));
    EXPECT_TRUE(triangle.is_missed_by(normalised({1, 1, -2}), 0.6)) << "wholly beyond the side in z = 0";
    EXPECT_FALSE(triangle.is_missed_by(normalised({1, 1, -2}), 0.5));
}

TEST(ReentrantTriangle, NoProbeReachesOneThatLiesBeforeThePlaneOfItsAtoms) {
    const double probe = 1.4;
    const AccessibleSurface surface(random_cluster(80, 12.0, 1.5), probe);
    const std::vector<SasVertex>& vertices = surface.data().vertices;
    std::size_t count = 0;
    for (const SasVertex& vertex : vertices) {
        const ReentrantTriangle triangle(surface.data(), vertex);
        if (!triangle.out_of_reach) continue;
        ++count;
        for (int i = 0; i <= 10; ++i)
            for (int j = 0; i + j <= 10; ++j) {
                const Vec3 n = normalised(static_cast<double>(i) * triangle.corners[0] +
                                          static_cast<double>(j) * triangle.corners[1] +
                                          static_cast<double>(10 - i - j) * triangle.corners[2]);
                const Vec3 point = vertex.position + probe * n;
                for (const SasVertex& other : vertices) ASSERT_GT(norm(point - other.position), probe - 1e-9);
            }
    }
    EXPECT_GT(count, vertices.size() / 2);
    EXPECT_LT(count, vertices.size());
}

// Squares of their radii are beyond single precision.
TEST(NearProbes, NothingButProbesIsListedHoweverLargeTheyAre) {
    const AccessibleSurface surface(random_cluster(80, 12.0, 1.5), 1.4);
    for (const double probe : {1e10, 1e18, 1e22, 1e25, 1e30}) {
        AccessibleSurface::Data data = surface.data();
        data.probe = probe;
        NearProbes near(data);
        for (std::uint32_t v = 0; v < data.vertices.size(); ++v) {
            near.visit(v);
            for (const std::uint32_t w : near.reaching()) {
                ASSERT_LT(w, data.vertices.size()) << probe;
                ASSERT_NE(w, v);
            }
            EXPECT_TRUE(near.triangle().out_of_reach || near.reaching().size() + 1 == data.vertices.size()) << probe;
        }
    }
}

TEST(NearProbes, AllThatReachIntoATriangleAreAmongThoseListed) {
    for (const double probe : {0.3, 1.4, 6.0}) {
        const AccessibleSurface surface(random_cluster(80, 12.0, 1.5), probe);
        const std::vector<SasVertex>& vertices = surface.data().vertices;
        ASSERT_GT(vertices.size(), 20U);
        NearProbes near(surface.data());
        for (std::uint32_t v = 0; v < vertices.size(); ++v) {
            near.visit(v);
            if (near.triangle().out_of_reach) continue;
            const auto reaching = near.reaching();
            EXPECT_TRUE(std::is_sorted(reaching.begin(), reaching.end()));
            EXPECT_FALSE(std::binary_search(reaching.begin(), reaching.end(), v));
            for (std::uint32_t w = 0; w < vertices.size(); ++w) {
                const Vec3 between = vertices[w].position - vertices[v].position;
                const double d = norm(between);
                if (w == v || d >= 2.0 * probe) continue;
                if (d > 1e-6 && near.triangle().is_missed_by((1.0 / d) * between, 0.5 * d / probe)) continue;
                EXPECT_TRUE(std::binary_search(reaching.begin(), reaching.end(), w)) << v << ' ' << w;
            }
        }
    }
}

}  // namespace
}  // namespace meniscus
