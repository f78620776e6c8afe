// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/cube_walk.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace meniscus::testing {
namespace {

using Cube = std::array<std::int64_t, 3>;

std::vector<Cube> cubes_along(const Line& line, double edge, const Stretch& stretch) {
    std::vector<Cube> cubes;
    CubeWalk walk(line, edge, stretch);
    double reached = stretch.begin;
    do {
        EXPECT_EQ(walk.part().begin, reached) << "no gaps";
        EXPECT_LE(walk.part().begin, walk.part().end);
        reached = walk.part().end;
        cubes.push_back(walk.cube());
    } while (walk.advance());
    EXPECT_EQ(reached, stretch.end);
    return cubes;
}

TEST(CubeWalk, PassesCubesAlongAnAxisInEitherDirection) {
    EXPECT_EQ(cubes_along({{0.5, 1.5, 2.5}, {1, 0, 0}}, 1.0, {0.0, 2.0}),
              (std::vector<Cube>{{0, 1, 2}, {1, 1, 2}, {2, 1, 2}}));
    EXPECT_EQ(cubes_along({{0.5, 1.5, 2.5}, {0, -1, 0}}, 1.0, {0.0, 2.0}),
              (std::vector<Cube>{{0, 1, 2}, {0, 0, 2}, {0, -1, 2}}));
    EXPECT_EQ(cubes_along({{0.5, 1.5, 2.5}, {1, 0, 0}}, 8.0, {0.0, 2.0}), (std::vector<Cube>{{0, 0, 0}}));
}

TEST(CubeWalk, EveryPointOfTheLineIsInItsCube) {
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    for (int n = 0; n < 500; ++n) {
        const Line line{{9 * within(random), 9 * within(random), 9 * within(random)},
                        {within(random), within(random), n % 3 == 0 ? 0.0 : within(random)}};
        for (const double edge : {1.0, 8.0}) {
            CubeWalk walk(line, edge, {1.0, 20.0});
            do {
                const double middle = 0.5 * (walk.part().begin + walk.part().end);
                for (std::size_t axis = 0; axis < 3; ++axis) {
                    const double at = line.at(axis, middle) / edge - static_cast<double>(walk.cube()[axis]);
                    EXPECT_GT(at, -1e-12);
                    EXPECT_LT(at, 1.0 + 1e-12);
                }
            } while (walk.advance());
        }
    }
}

TEST(CubeWalk, DirectionsAsGoodAsParallelDoNotStopIt) {
    for (const double tiny : {1e-31, 1e-310, -1e-310, -0.0})
        EXPECT_EQ(cubes_along({{0.0, 1.0, 0.5}, {1.0, tiny, tiny}}, 1.0, {0.5, 3.5}).size(), 4U);
}

TEST(CubeWalk, ClippingKeepsWhatIsInTheBox) {
    const std::array<double, 3> low{0, 0, 0};
    const std::array<double, 3> high{2, 2, 2};
    const Stretch through = clipped({{-1, 1, 1}, {1, 0, 0}}, {0.0, 100.0}, low, high);
    EXPECT_EQ(through.begin, 1.0);
    EXPECT_EQ(through.end, 3.0);
    EXPECT_TRUE(clipped({{-1, 3, 1}, {1, 0, 0}}, {0.0, 100.0}, low, high).empty());
    EXPECT_TRUE(clipped({{-1, 1, 1}, {-1, 0, 0}}, {0.0, 100.0}, low, high).empty());
    EXPECT_TRUE(clipped({{-1, 1, 1}, {1, 0, 0}}, {0.0, 0.5}, low, high).empty());
}

}  // namespace
}  // namespace meniscus::testing
