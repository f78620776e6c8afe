// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/saddles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/arrangements.h"
#include "support/test_data.h"
#include "tunnels/drilled_block.h"

namespace meniscus {
namespace {

std::vector<Saddle> saddles_of(const Atoms& atoms, double min_radius, double cube = 4.0) {
    const Clearance clearance(atoms);
    return find_saddles(clearance, {.box = clearance.box_of_centres(), .min_radius = min_radius, .cube = cube});
}

// All triples, and all atoms for each: the definition.
std::vector<Saddle> brute_force(const Atoms& atoms, double min_radius) {
    const Clearance clearance(atoms);
    const CanonicalAtoms& sorted = clearance.atoms();
    const auto n = static_cast<std::uint32_t>(sorted.size());
    std::vector<Saddle> found;
    for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = i + 1; j < n; ++j)
            for (std::uint32_t k = j + 1; k < n; ++k)
                for (Saddle saddle : tangent_balls({sorted.centres[i], sorted.centres[j], sorted.centres[k]},
                                                   {sorted.radii[i], sorted.radii[j], sorted.radii[k]})) {
                    if (saddle.radius < min_radius || clearance.at(saddle.position) < saddle.radius - 1e-9) continue;
                    saddle.atoms = {i, j, k};
                    found.push_back(saddle);
                }
    return found;
}

// Soddy's inner circle of three circles that touch each other.
TEST(TangentBalls, LieBetweenThreeTouchingBallsAsSoddySays) {
    // Radii 1, 2, 3: the centres make a right triangle with sides 3, 4, 5, and the circle between has radius 6/23.
    const std::vector<Saddle> found = tangent_balls({{{0, 0, 0}, {3, 0, 0}, {0, 4, 0}}}, {1.0, 2.0, 3.0});
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].radius, 6.0 / 23.0, 1e-14);
    EXPECT_NEAR(norm(found[0].position), 1.0 + 6.0 / 23.0, 1e-14);
    EXPECT_NEAR(norm(found[0].position - Vec3{3, 0, 0}), 2.0 + 6.0 / 23.0, 1e-14);
    EXPECT_NEAR(norm(found[0].position - Vec3{0, 4, 0}), 3.0 + 6.0 / 23.0, 1e-14);
}

TEST(TangentBalls, OfEqualBallsAreCircumscribed) {
    const std::vector<Saddle> found = tangent_balls({{{0, 0, 0}, {6, 0, 0}, {3, 5, 0}}}, {1.5, 1.5, 1.5});
    ASSERT_EQ(found.size(), 1U);
    // a b c / (4 area) less the radius
    EXPECT_NEAR(found[0].radius, 6.0 * 34.0 / (4.0 * 15.0) - 1.5, 1e-13);
}

TEST(TangentBalls, AreNoneWhereTheTriangleIsObtuseOrFlat) {
    EXPECT_TRUE(tangent_balls({{{0, 0, 0}, {10, 0, 0}, {5, 1, 0}}}, {1.0, 1.0, 1.0}).empty());
    EXPECT_TRUE(tangent_balls({{{0, 0, 0}, {10, 0, 0}, {5, 0, 0}}}, {1.0, 1.0, 1.0}).empty());
}

TEST(Saddles, OfARingOfBeadsAreOne) {
    const std::vector<Saddle> found = saddles_of(testing::ring(24, 5.0, 1.5), 0.5);
    ASSERT_EQ(found.size(), 1U);
    EXPECT_NEAR(found[0].radius, 3.5, 1e-12);
    EXPECT_NEAR(norm(found[0].position), 0.0, 1e-12);
    EXPECT_NEAR(std::abs(found[0].normal.z), 1.0, 1e-12);
}

TEST(Saddles, AreThoseOfAllTriples) {
    for (const unsigned seed : {1U, 2U, 3U}) {
        const Atoms atoms = testing::random_beads(seed, 70, 13.0);
        const std::vector<Saddle> expected = brute_force(atoms, 0.3);
        const std::vector<Saddle> found = saddles_of(atoms, 0.3);
        ASSERT_GT(expected.size(), 30U);
        ASSERT_EQ(found.size(), expected.size());
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].atoms, expected[i].atoms);
            EXPECT_EQ(found[i].radius, expected[i].radius);
        }
    }
}

TEST(Saddles, DoNotDependOnTheCubesOfTheSearch) {
    MENISCUS_NEED_TEST_DATA();
    Atoms atoms = testing::read_spheres(*testing::test_data() / "reference/xyzr/1fss.xyzr");
    const Clearance clearance(atoms);
    const Vec3 middle = clearance.box_of_centres().middle();
    const Box box = Box{middle, middle}.grown(9.0);
    const auto of_cubes = [&](double cube) {
        std::vector<Saddle> found = find_saddles(clearance, {.box = box, .min_radius = 0.9, .cube = cube});
        // The last cubes reach beyond the box.
        std::erase_if(found, [&](const Saddle& s) { return box.squared_distance(s.position) > 0.0; });
        return found;
    };
    const std::vector<Saddle> expected = of_cubes(4.0);
    EXPECT_GT(expected.size(), 10U);
    for (const double cube : {1.0, 0.7, 0.5, 0.35}) {
        const std::vector<Saddle> found = of_cubes(cube);
        ASSERT_EQ(found.size(), expected.size()) << cube;
        for (std::size_t i = 0; i < found.size(); ++i) {
            EXPECT_EQ(found[i].atoms, expected[i].atoms);
            EXPECT_EQ(found[i].radius, expected[i].radius);
            EXPECT_EQ(found[i].position, expected[i].position);
        }
    }
}

}  // namespace
}  // namespace meniscus
