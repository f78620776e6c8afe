// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points that stand for equal parts of a triangle.
#pragma once

#include <cstddef>

#include "meniscus/mesh.h"

namespace meniscus {

/// Divides a triangle into n² equal ones, similar to it, and calls visit(centroid) for each.
template <class Visit>
void for_each_part(const Mesh& mesh, const Triangle& triangle, std::size_t n, const Visit& visit) {
    const Vec3& a = mesh.vertices[triangle[0]];
    const double step = 1.0 / static_cast<double>(n);
    const Vec3 u = step * (mesh.vertices[triangle[1]] - a);
    const Vec3 v = step * (mesh.vertices[triangle[2]] - a);
    const auto at = [&](std::size_t i, std::size_t j, double third) {
        visit(a + (static_cast<double>(i) + third) * u + (static_cast<double>(j) + third) * v);
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; i + j < n; ++j) {
            at(i, j, 1.0 / 3.0);
            if (i + j + 1 < n) at(i, j, 2.0 / 3.0);
        }
}

inline double area_of(const Mesh& mesh, const Triangle& t) {
    const Vec3& a = mesh.vertices[t[0]];
    return 0.5 * norm(cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a));
}

}  // namespace meniscus
