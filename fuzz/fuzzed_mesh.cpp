// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "fuzzed_mesh.h"

#include <cmath>

#include "meniscus/read_mesh.h"

namespace meniscus::fuzz {
namespace {

void require_sound(const Mesh& mesh) {
    for (const Vec3& p : mesh.vertices)
        require(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z), "coordinates are finite");
    for (const Triangle& triangle : mesh.triangles)
        for (const VertexId corner : triangle) require(corner < mesh.vertices.size(), "a corner names a vertex");
}

}  // namespace

void read_mesh_or_refuse(const std::string& path, const std::string& named) {
    read_or_refuse(named, [&] { require_sound(read_mesh(path)); });
}

}  // namespace meniscus::fuzz
