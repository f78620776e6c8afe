// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What triangles add to the area and the volume of a mesh.
#pragma once

namespace meniscus {

/// Twice the area, Å², and six times the volume over the origin, Å³.
struct TriangleSum {
    double two_areas = 0.0;
    double six_volumes = 0.0;

    TriangleSum& operator+=(const TriangleSum& b) {
        two_areas += b.two_areas;
        six_volumes += b.six_volumes;
        return *this;
    }
};

}  // namespace meniscus
