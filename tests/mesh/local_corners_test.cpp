// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/local_corners.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <random>
#include <set>
#include <vector>

namespace meniscus {
namespace {

// Of so many triangles with corners among the first `most` numbers.
std::vector<Triangle> random_triangles(std::size_t count, VertexId most, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::vector<Triangle> triangles(count);
    for (Triangle& triangle : triangles)
        for (VertexId& v : triangle) v = static_cast<VertexId>(random() % most);
    return triangles;
}

TEST(LocalCorners, AreNumberedInTheOrderOfTheMeshHoweverFarApartTheyLie) {
    for (const VertexId most : {1U, 64U, 100U, 5'000U, 1'000'000U, 4'294'967'295U})
        for (const std::size_t count : {1U, 2U, 30U, 700U}) {
            const std::vector<Triangle> triangles = random_triangles(count, most, most);
            std::vector<VertexId> corners;
            for (const Triangle& t : triangles) corners.insert(corners.end(), t.begin(), t.end());
            const std::set<VertexId> expected(corners.begin(), corners.end());
            const LocalCorners local(corners);
            ASSERT_EQ(local.vertices(), std::vector<VertexId>(expected.begin(), expected.end()))
                << most << ' ' << count;
            for (const Triangle& t : triangles) {
                const Triangle numbers = local.local(t);
                for (std::size_t k = 0; k < 3; ++k) ASSERT_EQ(local.vertices().at(numbers[k]), t[k]);
            }
        }
}

TEST(LocalCorners, OfNoTrianglesThereAreNone) { EXPECT_TRUE(LocalCorners({}).vertices().empty()); }

TEST(LocalCorners, TheLargestNumbersAreNumbers) {
    const LocalCorners local({4'294'967'295U, 0U, 4'294'967'294U});
    EXPECT_EQ(local.vertices(), (std::vector<VertexId>{0U, 4'294'967'294U, 4'294'967'295U}));
    EXPECT_EQ(local.local({4'294'967'295U, 0U, 4'294'967'294U}), (Triangle{2, 0, 1}));
}

}  // namespace
}  // namespace meniscus
