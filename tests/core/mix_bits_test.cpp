// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/mix_bits.h"

#include <gtest/gtest.h>

#include <set>

namespace meniscus {
namespace {

TEST(MixBits, TellsNeighboursApart) {
    std::set<std::uint64_t> seen;
    for (std::uint64_t i = 0; i < 10000; ++i) seen.insert(mix_bits(i + kMixIncrement));
    EXPECT_EQ(seen.size(), 10000U);
}

TEST(MixBits, SignedUnitFillsItsRangeEvenly) {
    double sum = 0.0;
    double squares = 0.0;
    constexpr int kCount = 100000;
    for (std::uint64_t i = 0; i < kCount; ++i) {
        const double u = signed_unit(mix_bits(i + kMixIncrement));
        ASSERT_GE(u, -1.0);
        ASSERT_LT(u, 1.0);
        sum += u;
        squares += u * u;
    }
    EXPECT_NEAR(sum / kCount, 0.0, 0.01);
    EXPECT_NEAR(squares / kCount, 1.0 / 3.0, 0.01);
}

}  // namespace
}  // namespace meniscus
