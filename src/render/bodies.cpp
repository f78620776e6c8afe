// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "meniscus/picture.h"

namespace meniscus {

Bodies joined(Bodies bodies, const Bodies& more) {
    Mesh& mesh = bodies.mesh;
    const auto first = static_cast<VertexId>(mesh.vertices.size());
    const std::uint32_t next =
        mesh.components.empty() ? 0 : *std::max_element(mesh.components.begin(), mesh.components.end()) + 1;
    mesh.vertices.insert(mesh.vertices.end(), more.mesh.vertices.begin(), more.mesh.vertices.end());
    mesh.normals.insert(mesh.normals.end(), more.mesh.normals.begin(), more.mesh.normals.end());
    for (const std::uint32_t component : more.mesh.components) mesh.components.push_back(next + component);
    for (const Triangle& t : more.mesh.triangles) mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
    bodies.colours.insert(bodies.colours.end(), more.colours.begin(), more.colours.end());
    return bodies;
}

}  // namespace meniscus
