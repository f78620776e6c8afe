// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Caps of the unit sphere of directions, and where an arc of a cap's rim lies.
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

/// A cap of directions (n·middle >= cosine |middle|) that holds all of an arc. The middle has any length up to 2, and
/// cosine and sine are multiplied by that length: no root of it and no division.
struct ArcExtent {
    static constexpr double kSlack = 2e-9;  ///< for rounding; what is not ruled out is examined

    Vec3 middle;
    double cosine = 0.0;
    double sine = 0.0;
};

}  // namespace meniscus
