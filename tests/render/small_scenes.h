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

inline const Colour& pixel(const Picture& picture, int x, int y) {
    return picture
        .pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(picture.width) + static_cast<std::size_t>(x)];
}

}  // namespace meniscus::testing
