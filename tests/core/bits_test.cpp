// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/bits.h"

#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <random>
#include <vector>

namespace meniscus {
namespace {

TEST(Bits, AreCountedAsTheLibraryDoes) {
    static_assert(count_bits(0) == 0);
    static_assert(count_bits(~std::uint64_t{0}) == 64);
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t word = random() & random();
        EXPECT_EQ(count_bits(word), static_cast<std::uint64_t>(std::popcount(word)));
    }
    for (int bit = 0; bit < 64; ++bit) EXPECT_EQ(count_bits(std::uint64_t{1} << bit), 1U);
}

TEST(Bits, FirstOnesAreTheLowest) {
    static_assert(first_bits(0) == 0);
    static_assert(first_bits(1) == 1);
    static_assert(first_bits(63) == ~std::uint64_t{0} >> 1U);
    static_assert(first_bits(64) == ~std::uint64_t{0});
}

TEST(Bits, VisitsTheItemsOfASetInOrder) {
    const std::array<std::uint64_t, 2> words{std::uint64_t{1} << 63U | 2U, 1U};
    std::vector<std::size_t> visited;
    for_each_item(words.data(), 65, [&](std::size_t item) { visited.push_back(item); });
    EXPECT_EQ(visited, (std::vector<std::size_t>{1, 63, 64}));
}

TEST(Bits, ListsTheItemsOfASetInOrder) {
    const std::array<std::uint64_t, 3> words{0b101U, 0, std::uint64_t{1} << 63U | 1U};
    std::array<std::uint32_t, 192> list{};
    ASSERT_EQ(list_items(words.data(), 192, list.data()), 4U);
    EXPECT_EQ(std::vector<std::uint32_t>(list.begin(), list.begin() + 4), (std::vector<std::uint32_t>{0, 2, 128, 191}));
    EXPECT_EQ(list_items(words.data(), 0, list.data()), 0U);
    EXPECT_EQ(words_for(64), 1U);
    EXPECT_EQ(words_for(65), 2U);
}

}  // namespace
}  // namespace meniscus
