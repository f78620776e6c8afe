// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Meshes of one colour to draw, for tests.
#pragma once

#include <vector>

#include "meniscus/picture.h"
#include "support/shapes.h"

namespace meniscus::testing {

inline constexpr Colour kBlue{119, 170, 221, 255};
inline constexpr Viewpoint kFront{};
inline const Bodies kNoBodies;

struct ColouredMesh {
    Mesh mesh;
    std::vector<Colour> colours;
};

inline ColouredMesh blue_sphere(const Sphere& sphere, double spacing) {
    ColouredMesh coloured{.mesh = projected_sphere(sphere, spacing), .colours = {}};
    coloured.colours.assign(coloured.mesh.vertices.size(), kBlue);
    return coloured;
}

inline void append(ColouredMesh& to, const ColouredMesh& other) {
    append(to.mesh, other.mesh);
    to.mesh.normals.insert(to.mesh.normals.end(), other.mesh.normals.begin(), other.mesh.normals.end());
    to.colours.insert(to.colours.end(), other.colours.begin(), other.colours.end());
}

inline constexpr Sphere kCheese{.centre = {}, .radius = 4.0};
inline constexpr Sphere kLargeHole{.centre = {1.5, 0, 0.5}, .radius = 1.5};
inline constexpr Sphere kSmallHole{.centre = {-1.5, 0.5, 0}, .radius = 1.0};

inline ColouredMesh turned_inside_out(ColouredMesh coloured) {
    coloured.mesh = turned_inside_out(coloured.mesh);
    for (SmallVec3& normal : coloured.mesh.normals) normal = -normal;
    return coloured;
}

/// A ball with two cavities, the smaller one before the larger one.
inline ColouredMesh cheese() {
    ColouredMesh all = blue_sphere(kCheese, 0.2);
    all.mesh.components.assign(all.mesh.vertices.size(), 0);
    for (const Sphere& hole : {kSmallHole, kLargeHole}) {
        const std::uint32_t component = all.mesh.components.back() + 1;
        append(all, turned_inside_out(blue_sphere(hole, 0.1)));
        all.mesh.components.resize(all.mesh.vertices.size(), component);
    }
    return all;
}

inline const Colour& pixel(const Picture& picture, int x, int y) {
    return picture
        .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)];
}

}  // namespace meniscus::testing
