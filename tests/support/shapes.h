// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Signed distances of simple shapes and meshes made in code, for tests. Negative inside.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "meniscus/mesh.h"
#include "mesh/extract.h"
#include "support/sampled_field.h"

namespace meniscus::testing {

struct Sphere {
    Vec3 centre;
    double radius = 1.0;
    double operator()(const Vec3& p) const { return norm(p - centre) - radius; }
};

/// A torus round the z axis: tube radius `minor` round a circle of radius `major`.
struct Torus {
    double major = 2.0;
    double minor = 1.0;
    double operator()(const Vec3& p) const { return std::hypot(std::hypot(p.x, p.y) - major, p.z) - minor; }
};

/// A sphere sampled at a spacing and extracted.
inline Mesh extracted_sphere(const Sphere& sphere, double spacing) {
    const Vec3 r{sphere.radius, sphere.radius, sphere.radius};
    const SampledField field = sample_box(spacing, sphere.centre - r, sphere.centre + r, sphere);
    return extract_zero_set(field.grid, field.values);
}

/// The same with vertices moved onto the sphere and exact normals.
inline Mesh projected_sphere(const Sphere& sphere, double spacing) {
    Mesh mesh = extracted_sphere(sphere, spacing);
    for (Vec3& v : mesh.vertices) {
        const Vec3 normal = normalised(v - sphere.centre);
        mesh.normals.push_back(to_small(normal));
        v = sphere.centre + sphere.radius * normal;
    }
    return mesh;
}

/// Appends a mesh's positions and triangles to another's.
inline void append(Mesh& to, const Mesh& mesh) {
    const auto shift = static_cast<VertexId>(to.vertices.size());
    to.vertices.insert(to.vertices.end(), mesh.vertices.begin(), mesh.vertices.end());
    for (const auto& [a, b, c] : mesh.triangles) to.triangles.push_back({a + shift, b + shift, c + shift});
}

/// The same surface with its sides exchanged: the wall of a cavity.
inline Mesh turned_inside_out(Mesh mesh) {
    for (Triangle& t : mesh.triangles) std::swap(t[1], t[2]);
    return mesh;
}

/// A regular tetrahedron with corners at (±1, ±1, ±1): volume 8/3, area 8 sqrt(3).
inline Mesh tetrahedron() {
    return {.vertices = {{1, 1, 1}, {-1, -1, 1}, {-1, 1, -1}, {1, -1, -1}},
            .normals = {},
            .atoms = {},
            .patches = {},
            .components = {},
            .triangles = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

}  // namespace meniscus::testing
