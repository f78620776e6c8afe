// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/depths.h"

#include <algorithm>

#include "meniscus/colours.h"

namespace meniscus {

std::vector<double> depths(const Mesh& mesh, const ExactSurface& exact) {
    const ExactSurface rolled = exact.of_same_atoms({SurfaceKind::Ses, kDepthProbe});
    std::vector<double> depth = rolled.signed_distance(mesh.vertices);
    for (double& d : depth) d = std::max(0.0, -d);
    return depth;
}

VertexValues depth_values(const Mesh& mesh, const ExactSurface& exact) {
    const std::vector<double> depth = depths(mesh, exact);
    return {"depth", {depth.begin(), depth.end()}};
}

const VertexValues* brought_depths(const Mesh& mesh) {
    const auto found = std::find_if(mesh.values.begin(), mesh.values.end(),
                                    [](const VertexValues& values) { return values.name == "depth"; });
    return found == mesh.values.end() ? nullptr : &*found;
}

}  // namespace meniscus
