// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/box_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

std::vector<Vec3> random_points(const Box& box, std::size_t count, std::mt19937& random) {
    std::uniform_real_distribution<double> part(0.0, 1.0);
    const Vec3 size = box.high - box.low;
    std::vector<Vec3> points(count);
    for (Vec3& p : points) p = box.low + Vec3{part(random) * size.x, part(random) * size.y, part(random) * size.z};
    return points;
}

void expect_exact(const AccessibleSurface& surface, BoxFeatures& distances, const Box& box, std::mt19937& random) {
    const double middle = distances.enter(box);
    EXPECT_EQ(middle, surface.nearest(box.middle()).signed_distance);
    for (const std::size_t count : {std::size_t{1}, std::size_t{7}, kBatchLanes}) {
        const std::vector<Vec3> points = random_points(box, count, random);
        std::array<double, kBatchLanes> found{};
        distances.find(points, found);
        for (std::size_t i = 0; i < count; ++i) {
            EXPECT_EQ(found[i], surface.nearest(points[i]).signed_distance);
            EXPECT_LE(std::abs(found[i] - middle), 0.5 * norm(box.high - box.low) + 1e-9);
        }
    }
}

// From deep inside to far outside, in boxes smaller and larger than atoms.
TEST(BoxFeatures, AreTheExactOnesHoweverFarAway) {
    std::mt19937 random(2);
    for (const Atoms& atoms : {equal_spheres({{1, 2, 3}}, 1.7), two_spheres(2.0), ridged_spheres(),
                               octahedron(3.0, 1.7), hollow_shell(90, 9.0, 1.7), random_cluster(3, 150, 14.0)})
        for (const double probe : {0.0, 1.4, 3.0}) {
            const AccessibleSurface surface(atoms, probe);
            BoxFeatures distances(surface);
            Box all;
            for (const Vec3& centre : atoms.centres) all.include(centre);
            for (const double reach : {0.5, 6.0, 40.0})
                for (const double edge : {0.0, 0.4, 3.5, 12.0})
                    for (const Vec3& corner : random_points(all.grown(reach), 4, random))
                        expect_exact(surface, distances, {corner, corner + Vec3{edge, 0.7 * edge, edge}}, random);
        }
}

// In the order of the points, wherever they are, alone or many.
TEST(BoxFeatures, OfPointsAllOverSpaceAreTheExactOnes) {
    std::mt19937 random(5);
    const AccessibleSurface surface(random_cluster(3, 150, 14.0), 1.4);
    EXPECT_TRUE(signed_distance(surface, {}).empty());
    for (const double reach : {8.0, 1e3, 1e9})
        for (const std::size_t count : {std::size_t{1}, std::size_t{300}, std::size_t{3000}}) {
            std::vector<Vec3> points = random_points({{-reach, -reach, -reach}, {reach, reach, reach}}, count, random);
            points.push_back(points[count / 2]);
            const std::vector<double> found = signed_distance(surface, points);
            ASSERT_EQ(found.size(), points.size());
            for (std::size_t i = 0; i < points.size(); ++i)
                ASSERT_EQ(found[i], surface.nearest(points[i]).signed_distance) << reach << ' ' << i;
        }
}

}  // namespace
}  // namespace meniscus::testing
