// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What triangles add to the area and the volume of a mesh.
#pragma once

#include "meniscus/vec3.h"

namespace meniscus {

/// Twice the area and six times the volume over the origin.
struct TriangleSum {
    double two_areas = 0.0;
    double six_volumes = 0.0;

    void add(const Vec3& a, const Vec3& b, const Vec3& c) {
        const Vec3 normal = cross(b - a, c - a);
        two_areas += norm(normal);
        six_volumes += dot(a, normal);
    }
    TriangleSum& operator+=(const TriangleSum& b) {
        two_areas += b.two_areas;
        six_volumes += b.six_volumes;
        return *this;
    }
};

}  // namespace meniscus
