// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/count_bits.h"

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace meniscus {
namespace {

TEST(CountBits, CountsAsTheLibraryDoes) {
    static_assert(count_bits(0) == 0);
    static_assert(count_bits(~std::uint64_t{0}) == 64);
    std::mt19937_64 random(1);
    for (int i = 0; i < 1000; ++i) {
        const std::uint64_t word = random() & random();
        EXPECT_EQ(count_bits(word), static_cast<std::uint64_t>(std::popcount(word)));
    }
    for (int bit = 0; bit < 64; ++bit) EXPECT_EQ(count_bits(std::uint64_t{1} << bit), 1U);
}

}  // namespace
}  // namespace meniscus
