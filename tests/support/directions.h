// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Directions all around, for tests.
#pragma once

#include <vector>

#include "meniscus/vec3.h"

namespace meniscus::testing {

/// From the middle of a cube to its 26 neighbours; not of unit length.
inline std::vector<Vec3> directions_around() {
    std::vector<Vec3> directions;
    for (const double z : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 1.0})
            for (const double x : {-1.0, 0.0, 1.0})
                if (x != 0.0 || y != 0.0 || z != 0.0) directions.push_back({x, y, z});
    return directions;
}

}  // namespace meniscus::testing
