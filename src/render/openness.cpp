// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/openness.h"

#include "core/parallel.h"
#include "render/camera.h"
#include "render/scene.h"

namespace meniscus {

std::vector<float> openness(const Mesh& mesh) {
    const Camera camera(mesh.vertices, {});
    const RayScene rays(mesh);
    const SkyLight sky(rays, mesh, reach_of_sky(camera));
    std::vector<float> shares(mesh.vertices.size());
    parallel_for(shares.size(), 256, [&](std::size_t v) { shares[v] = sky.at(static_cast<VertexId>(v)); });
    return shares;
}

}  // namespace meniscus
