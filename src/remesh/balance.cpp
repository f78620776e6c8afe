// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/balance.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "core/parallel.h"
#include "remesh/self_intersections.h"
#include "remesh/working_mesh.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 512;  // triangles projected at once

// Over a triangle whose corners lie on a surface of constant curvature, the mean height of the surface is this part of
// that over the centroid.
constexpr double kMeanOfHighest = 0.75;

// Of an edge: more than the mean height over triangles on a sphere of an edge's radius.
constexpr double kFarthest = 0.125;

// Triangles have no smaller angles than this (degrees) that they did not have before.
constexpr double kSmallAngle = 25.0;

// Vertices stay so near to where the mesh would pass through itself or get a small angle, in edges, times the number of
// the try.
constexpr double kReach = 1.0;
constexpr int kTries = 4;

// Mean height of the surface over each triangle, Å.
std::vector<double> heights(const Mesh& mesh, double edge, const SurfaceProjector& project) {
    std::vector<double> heights(mesh.triangles.size());
    parallel_chunks(heights.size(), kChunk, [&](std::size_t begin, std::size_t end) {
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

// The mean of the heights round each vertex, by area.
std::vector<double> offsets(const Mesh& mesh, const std::vector<double>& heights) {
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

// Where a triangle has got a small angle.
void add_narrowed(const Mesh& mesh, std::span<const Vec3> before, std::vector<Vec3>& places) {
    const double narrow = std::cos(kSmallAngle * std::numbers::pi / 180.0);
    const auto is_narrow = [&](std::span<const Vec3> vertices, const Triangle& t) {
        return cosine_of_smallest_angle(vertices[t[0]], vertices[t[1]], vertices[t[2]]) > narrow;
    };
    for (const Triangle& t : mesh.triangles)
        if (is_narrow(mesh.vertices, t) && !is_narrow(before, t)) places.push_back(before[t[0]]);
}

}  // namespace

void balance_triangles(Mesh& mesh, double edge, const SurfaceProjector& project) {
    const std::vector<double> by = offsets(mesh, heights(mesh, edge, project));
    const std::vector<Vec3> before = mesh.vertices;
    const std::vector<Vec3> places = places_of_self_intersections(mesh);
    const Surroundings old{places, edge};
    for (std::size_t v = 0; v < by.size(); ++v) mesh.vertices[v] += by[v] * mesh.normals[v];
    std::vector<Vec3> spoiled;
    for (int i = 1; i <= kTries; ++i) {
        std::vector<Vec3> found = places_of_self_intersections(mesh);
        std::erase_if(found, [&](const Vec3& place) { return old.contain(place); });
        add_narrowed(mesh, before, found);
        if (found.empty()) return;
        spoiled.insert(spoiled.end(), found.begin(), found.end());
        const Surroundings near{spoiled, i * kReach * edge};
        for (std::size_t v = 0; v < by.size(); ++v)
            if (near.contain(before[v])) mesh.vertices[v] = before[v];
    }
    mesh.vertices = before;
}

}  // namespace meniscus
