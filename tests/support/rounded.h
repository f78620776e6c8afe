// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Unit vectors in single precision against what they were rounded from.
#pragma once

#include <gtest/gtest.h>

#include "meniscus/vec3.h"

namespace meniscus::testing {

/// As near as rounding allows, and no farther than `error` beyond that.
inline void expect_rounded_from(const SmallVec3& direction, const Vec3& unit, double error) {
    constexpr double kHalfStep = 0x1p-25;  // of floats below 1
    EXPECT_NEAR(direction.x, unit.x, kHalfStep + error);
    EXPECT_NEAR(direction.y, unit.y, kHalfStep + error);
    EXPECT_NEAR(direction.z, unit.z, kHalfStep + error);
}

}  // namespace meniscus::testing
