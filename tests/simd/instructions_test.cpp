// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "simd/instructions.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>

namespace meniscus {
namespace {

constexpr std::array<std::string_view, 3> kAvailable{"plain", "avx2", "avx512"};

TEST(Instructions, AreChosenByName) {
    for (std::size_t i = 0; i < kAvailable.size(); ++i) EXPECT_EQ(choose_instructions(kAvailable, kAvailable[i]), i);
}

TEST(Instructions, AreTheFastestWhereTheNameIsUnknown) {
    EXPECT_EQ(choose_instructions(kAvailable, ""), 2U);
    EXPECT_EQ(choose_instructions(kAvailable, "abacus"), 2U);
    EXPECT_EQ(choose_instructions(std::array<std::string_view, 1>{"plain"}, "avx2"), 0U);
}

TEST(Instructions, AreWantedByTheEnvironment) {
    const char* wanted = std::getenv("MENISCUS_INSTRUCTIONS");
    EXPECT_EQ(wanted_instructions(), wanted != nullptr ? wanted : "");
}

}  // namespace
}  // namespace meniscus
