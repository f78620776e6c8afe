// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The angle by which turns never come back near to where they were.
#pragma once

#include <numbers>

namespace meniscus {

/// Of a circle cut in the golden ratio the smaller part, radian.
inline constexpr double kGoldenAngle = 2.0 * std::numbers::pi * (2.0 - std::numbers::phi);

}  // namespace meniscus
