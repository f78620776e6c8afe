// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/corner_numbers.h"

#include <gtest/gtest.h>

#include <vector>

namespace meniscus {
namespace {

TEST(CornerNumbers, AreThoseOfAllTrianglesOneAfterTheOther) {
    const std::vector<Triangle> triangles{{3, 1, 4}, {1, 5, 9}};
    const auto corners = all_corners(triangles);
    EXPECT_EQ(std::vector<VertexId>(corners.begin(), corners.end()), (std::vector<VertexId>{3, 1, 4, 1, 5, 9}));
    EXPECT_TRUE(all_corners({}).empty());
}

// Lists of all lengths up to several blocks, with the number at every place in turn, and at two.
TEST(CornerNumbers, AreFoundWhereverTheyAre) {
    for (std::size_t size = 0; size < 70; ++size)
        for (std::size_t at = 0; at < size; ++at) {
            std::vector<std::uint32_t> numbers(size, 0x80000001U);
            numbers[at] = numbers[at / 2] = 7;
            std::vector<std::size_t> expected{at / 2, at};
            if (at == 0) expected.pop_back();
            std::vector<std::size_t> found;
            for_each_equal(numbers, 7, [&](std::size_t i) { found.push_back(i); });
            ASSERT_EQ(found, expected);
            std::vector<std::size_t> unequal;
            const std::vector<std::uint32_t> others(size + 20, 0x80000001U);
            for_each_unequal(numbers, others, [&](std::size_t i) { unequal.push_back(i); });
            ASSERT_EQ(unequal, expected);
        }
}

}  // namespace
}  // namespace meniscus
