// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points next to a surface, chosen from others.
#pragma once

#include <cmath>
#include <vector>

#include "geometry/accessible_surface.h"

namespace meniscus::testing {

/// Those of the points that lie nearer to the solvent-excluded surface than `distance`.
inline std::vector<Vec3> near_surface(const AccessibleSurface& surface, std::vector<Vec3> points, double distance) {
    std::erase_if(points, [&](const Vec3& p) { return !(std::abs(surface.nearest(p).signed_distance) < distance); });
    return points;
}

}  // namespace meniscus::testing
