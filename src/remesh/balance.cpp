// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/balance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "core/parallel.h"
#include "measure/surface_measures.h"
#include "remesh/self_intersections.h"
#include "remesh/working_mesh.h"

namespace meniscus {
namespace {

constexpr std::size_t kTrianglesAtOnce = 512;  // triangles projected at once

// Over a triangle whose corners lie on a surface of constant curvature, the mean height of the surface is this part of
// that over the centroid.
constexpr double kMeanOfHighest = 0.75;

// In lengths of an edge: more than the mean height over triangles on a sphere whose radius is an edge.
constexpr double kFarthest = 0.125;

// Triangles have no smaller angles than this (degrees) that they did not have before.
constexpr double kSmallAngle = 25.0;

// Vertices stay so near to where the mesh would pass through itself or get a small angle, in edges, times the number of
// the try.
constexpr double kBalanceReach = 1.0;
constexpr int kTries = 4;

// Mean height of the surface over each triangle, Å.
std::vector<double> heights_over(const Mesh& mesh, double edge, const SurfaceProjector& project) {
    std::vector<double> heights(mesh.triangles.size());
    parallel_chunks(heights.size(), kTrianglesAtOnce, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3> centroids;
        std::vector<SurfacePoint> feet;
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            centroids.push_back((1.0 / 3.0) * (mesh.vertices[a] + mesh.vertices[b] + mesh.vertices[c]));
            feet.push_back({centroids.back(), mesh.normals[a]});
        }
        project(feet);
        for (std::size_t i = 0; i < feet.size(); ++i) {
            const double height = kMeanOfHighest * dot(feet[i].position - centroids[i], feet[i].normal);
            heights[begin + i] = std::clamp(height, -kFarthest * edge, kFarthest * edge);
        }
    });
    return heights;
}

// Where a mesh passes through itself within reach of some places, and some other such places: one triangle of two that
// meet there has a corner within an edge more, the other within two.
std::vector<Vec3> crossings_near(Mesh& mesh, std::span<const Vec3> places, double reach) {
    const Surroundings near{places, reach + 2.0 * longest_edge_of(mesh)};
    std::vector<bool> is_near;
    for (const Vec3& v : mesh.vertices) is_near.push_back(near.contain(v));
    std::vector<Triangle> some;
    for (const Triangle& t : mesh.triangles)
        if (std::any_of(t.begin(), t.end(), [&](VertexId v) { return is_near[v]; })) some.push_back(t);
    mesh.triangles.swap(some);
    std::vector<Vec3> found = places_of_self_intersections(mesh);
    mesh.triangles.swap(some);
    return found;
}

// Where a triangle has got a small angle.
void add_narrowed(const Mesh& mesh, std::span<const Vec3> before, std::vector<Vec3>& places) {
    const double narrow = elementary::cos(kSmallAngle * std::numbers::pi / 180.0);
    const auto is_narrow = [&](std::span<const Vec3> vertices, const Triangle& t) {
        return cosine_of_smallest_angle(vertices[t[0]], vertices[t[1]], vertices[t[2]]) > narrow;
    };
    for (const Triangle& t : mesh.triangles)
        if (is_narrow(mesh.vertices, t) && !is_narrow(before, t)) places.push_back(before[t[0]]);
}

}  // namespace

// The mean of the heights round each vertex, by area.
std::vector<double> balancing_offsets(const Mesh& mesh, double edge, const SurfaceProjector& project) {
    const std::vector<double> heights = heights_over(mesh, edge, project);
    std::vector<double> sums(mesh.vertices.size());
    std::vector<double> areas(mesh.vertices.size());
    for (std::size_t t = 0; t < heights.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const double area = norm(area_vector(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
        for (const VertexId v : mesh.triangles[t]) {
            sums[v] += area * heights[t];
            areas[v] += area;
        }
    }
    for (std::size_t v = 0; v < sums.size(); ++v) sums[v] = areas[v] > 0.0 ? sums[v] / areas[v] : 0.0;
    return sums;
}

std::vector<Vec3> vertices_moved(const Mesh& mesh, std::span<const double> offsets, double share) {
    std::vector<Vec3> moved = mesh.vertices;
    for (std::size_t v = 0; v < moved.size(); ++v) moved[v] += (share * offsets[v]) * mesh.normals[v];
    return moved;
}

void move_vertices(Mesh& mesh, std::vector<Vec3> wanted, double edge) {
    const std::vector<Vec3> before = std::exchange(mesh.vertices, std::move(wanted));
    std::vector<Vec3> found = places_of_self_intersections(mesh);
    std::vector<Vec3> spoiled;
    for (int i = 1;; ++i) {
        if (!found.empty()) {  // not those that were there before
            std::vector<Vec3> moved = std::exchange(mesh.vertices, before);
            const std::vector<Vec3> places = crossings_near(mesh, found, edge);
            mesh.vertices = std::move(moved);
            const Surroundings old{places, edge};
            std::erase_if(found, [&](const Vec3& place) { return old.contain(place); });
        }
        add_narrowed(mesh, before, found);
        if (found.empty()) return;
        if (i > kTries) break;
        spoiled.insert(spoiled.end(), found.begin(), found.end());
        const double reach = i * kBalanceReach * edge;
        const Surroundings near{spoiled, reach};
        for (std::size_t v = 0; v < before.size(); ++v)
            if (near.contain(before[v])) mesh.vertices[v] = before[v];
        found = crossings_near(mesh, spoiled, reach);
    }
    mesh.vertices = before;
}

}  // namespace meniscus
