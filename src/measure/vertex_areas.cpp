// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/vertex_areas.h"

namespace meniscus {

std::vector<float> vertex_areas(const Mesh& mesh, std::span<const float> thirds) {
    std::vector<float> areas(mesh.vertices.size(), 0.0F);
    for (std::size_t t = 0; t < thirds.size(); ++t)
        for (const VertexId v : mesh.triangles[t]) areas[v] += thirds[t];
    return areas;
}

}  // namespace meniscus
