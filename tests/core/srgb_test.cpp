// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/srgb.h"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

TEST(Srgb, BlackWhiteAndMiddleGreyAreWhereTheStandardHasThem) {
    EXPECT_EQ(linear_from_srgb(0.0), 0.0);
    EXPECT_NEAR(linear_from_srgb(1.0), 1.0, 1e-15);
    EXPECT_NEAR(linear_from_srgb(0.5), 0.21404114, 1e-8);
    EXPECT_NEAR(linear_from_srgb(0.04), 0.04 / 12.92, 1e-15);
}

TEST(Srgb, BothWaysGiveTheSameValueBack) {
    for (int i = 0; i <= 1000; ++i) EXPECT_NEAR(srgb_from_linear(linear_from_srgb(i / 1000.0)), i / 1000.0, 1e-7) << i;
}

}  // namespace
}  // namespace meniscus
