// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/component_colours.h"

#include <algorithm>

#include "colours/checks.h"
#include "colours/palettes.h"

namespace meniscus {
namespace {

/// Six times the volume that each component encloses, negative for the wall of a cavity.
std::vector<double> volumes_of_components(const Mesh& mesh) {
    if (mesh.components.empty()) return {};
    std::vector<double> volumes(std::size_t{*std::max_element(mesh.components.begin(), mesh.components.end())} + 1);
    const Vec3 origin = mesh.vertices.front();
    for (const auto& [a, b, c] : mesh.triangles)
        volumes[mesh.components[a]] +=
            dot(mesh.vertices[a] - origin, cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin));
    return volumes;
}

}  // namespace

std::vector<Colour> component_colours(const Mesh& mesh) {
    check_values(mesh.components, mesh, "component");
    std::vector<Colour> colours;
    std::size_t cavities = 0;
    for (const double volume : volumes_of_components(mesh))
        colours.push_back(volume < 0.0 ? distinct_colour(++cavities) : kPlain);
    return colours;
}

}  // namespace meniscus
