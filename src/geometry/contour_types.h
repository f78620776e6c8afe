// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Caps of the unit sphere of directions.
#pragma once

#include <cstdint>

#include "meniscus/vec3.h"

namespace meniscus {

/// A cap {n : n·axis > t} of the unit sphere of directions that neighbour `atom` buries; |t| < 1.
struct Cap {
    Vec3 axis;
    double t = 0.0;
    std::uint32_t atom = 0;
};

/// The same without saying whose it is.
struct CapPlane {
    Vec3 axis;
    double t = 0.0;
};

inline constexpr std::uint32_t kWholeCircle = 0xffffffffU;

}  // namespace meniscus
