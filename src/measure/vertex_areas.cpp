// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/vertex_areas.h"

namespace meniscus {

std::vector<float> vertex_areas(const Mesh& mesh) {
    std::vector<float> areas(mesh.vertices.size(), 0.0F);
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3& origin = mesh.vertices[a];
        const double doubled = norm(cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin));
        const auto third = static_cast<float>(doubled / 6.0);
        areas[a] += third;
        areas[b] += third;
        areas[c] += third;
    }
    return areas;
}

}  // namespace meniscus
