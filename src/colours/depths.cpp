// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/depths.h"

#include <algorithm>

#include "meniscus/accessible_surface.h"
#include "meniscus/colours.h"

namespace meniscus {

std::vector<double> depths(const Mesh& mesh, const Structure& structure) {
    std::vector<double> depth = signed_distance(AccessibleSurface(structure.atoms, kDepthProbe), mesh.vertices);
    for (double& d : depth) d = std::max(0.0, -d);
    return depth;
}

VertexValues depth_values(const Mesh& mesh, const Structure& structure) {
    const std::vector<double> depth = depths(mesh, structure);
    return {"depth", {depth.begin(), depth.end()}};
}

const VertexValues* brought_depths(const Mesh& mesh) {
    const auto found = std::find_if(mesh.values.begin(), mesh.values.end(),
                                    [](const VertexValues& values) { return values.name == "depth"; });
    return found == mesh.values.end() ? nullptr : &*found;
}

}  // namespace meniscus
