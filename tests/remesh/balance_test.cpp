// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/balance.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "remesh/self_intersections.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

SurfaceProjector onto(const Sphere& sphere) {
    return [sphere](std::span<SurfacePoint> points) {
        for (SurfacePoint& point : points) {
            point.normal = normalised(point.position - sphere.centre);
            point.position = sphere.centre + sphere.radius * point.normal;
        }
    };
}

Mesh even_sphere(const Sphere& sphere, double edge) {
    Mesh even = remesh(extracted_sphere(sphere, 0.4), {.edge = edge}, onto(sphere));
    for (const Vec3& v : even.vertices) even.normals.push_back(to_small(normalised(v - sphere.centre)));
    return even;
}

void balance(Mesh& mesh, double edge, const SurfaceProjector& project) {
    move_vertices(mesh, vertices_moved(mesh, balancing_offsets(mesh, edge, project), 1.0), edge);
}

Mesh both(Mesh mesh, const Mesh& second) {
    const auto first = static_cast<VertexId>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), second.vertices.begin(), second.vertices.end());
    mesh.normals.insert(mesh.normals.end(), second.normals.begin(), second.normals.end());
    for (const auto& [a, b, c] : second.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
    return mesh;
}

// Over the triangles, by the middles of a subdivision of each.
double mean_distance(const Mesh& mesh, const Sphere& sphere) {
    constexpr int kParts = 12;
    double sum = 0.0;
    double area = 0.0;
    for (const auto& [i, j, k] : mesh.triangles) {
        const Vec3& a = mesh.vertices[i];
        const Vec3 ab = mesh.vertices[j] - a;
        const Vec3 ac = mesh.vertices[k] - a;
        const double weight = norm(cross(ab, ac));
        for (int s = 0; s < kParts; ++s)
            for (int t = 0; s + t < kParts; ++t) {
                const Vec3 p = a + ((s + 1.0 / 3.0) / kParts) * ab + ((t + 1.0 / 3.0) / kParts) * ac;
                sum += weight * std::abs(sphere(p));
                area += weight;
            }
    }
    return sum / area;
}

TEST(Balance, PutsTrianglesOnBothSidesOfASphere) {
    const Sphere sphere{{0.1, -0.2, 0.05}, 3.0};
    const double volume = 4.0 / 3.0 * std::numbers::pi * std::pow(sphere.radius, 3);
    for (const double edge : {0.6, 1.0, 1.5}) {
        const Mesh before = even_sphere(sphere, edge);
        Mesh mesh = before;
        balance(mesh, edge, onto(sphere));
        expect_closed_manifold(mesh);
        EXPECT_LT(mean_distance(mesh, sphere), 0.6 * mean_distance(before, sphere)) << edge;
        const double missing = volume - measure_mesh(before).volume;
        EXPECT_NEAR(measure_mesh(mesh).volume, volume, 0.05 * missing) << edge;
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
            EXPECT_NEAR(norm(cross(mesh.vertices[v] - before.vertices[v], before.normals[v])), 0.0, 1e-12);
    }
}

TEST(Balance, LeavesWhatWouldPassThroughSomething) {
    // The inner of two spheres has large triangles and would grow through the outer one, which has small ones.
    const Sphere outer{{0.0, 0.0, 0.0}, 1.53};
    const Sphere inner{{0.0, 0.0, 0.0}, 1.47};
    Mesh outside = even_sphere(outer, 0.4);
    Mesh inside = even_sphere(inner, 1.2);
    Mesh mesh = both(outside, inside);
    ASSERT_TRUE(places_of_self_intersections(mesh).empty());
    balance(outside, 0.4, onto(outer));
    balance(inside, 1.2, onto(inner));
    ASSERT_FALSE(places_of_self_intersections(both(outside, inside)).empty());
    balance(mesh, 1.2, [&](std::span<SurfacePoint> points) {
        for (SurfacePoint& point : points) {
            const std::span<SurfacePoint> one(&point, 1);
            norm(point.position) > 1.5 - 1e-2 ? onto(outer)(one) : onto(inner)(one);
        }
    });
    EXPECT_TRUE(places_of_self_intersections(mesh).empty());
    expect_closed_manifold(mesh);
}

}  // namespace
}  // namespace meniscus::testing
