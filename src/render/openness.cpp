// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/openness.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "render/camera.h"
#include "render/scene.h"
#include "render/sky_light.h"

namespace meniscus {
namespace {

/// Rays per Å² of the surface: however fine the mesh is, the light costs the same.
constexpr double kRaysPerArea = 36.0;
constexpr double kFewestRays = 2.0;  // of a vertex
constexpr double kMostRays = 64.0;

/// Rounds of smoothing times the square of an edge, Å²: they blur the rays, however fine the mesh.
constexpr double kOpennessBlur = 0.4;
constexpr double kMostRounds = 20.0;

/// Every value becomes the mean of itself and those along the edges of its triangles.
std::vector<float> smoothed(const Mesh& mesh, const std::vector<float>& values) {
    std::vector<float> sum(values.size());
    std::vector<float> count(values.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const float all = values[a] + values[b] + values[c];
        for (const VertexId v : {a, b, c}) {
            sum[v] += all;
            count[v] += 3.0F;
        }
    }
    for (std::size_t v = 0; v < sum.size(); ++v) sum[v] = count[v] > 0.0F ? sum[v] / count[v] : values[v];
    return sum;
}

int rounds_of_smoothing(double edge) {
    return static_cast<int>(std::clamp(std::round(kOpennessBlur / (edge * edge)), 1.0, kMostRounds));
}

/// Twice as many equilateral triangles as vertices cover the surface.
std::size_t rays_of_vertex(double edge) {
    const double area = 0.5 * std::numbers::sqrt3 * edge * edge;
    return static_cast<std::size_t>(std::clamp(std::round(kRaysPerArea * area), kFewestRays, kMostRays));
}

}  // namespace

std::vector<float> openness(const Mesh& mesh, const RayScene& rays) {
    const Camera camera(mesh.vertices, {});
    const SkyRays sky(rays, mesh, reach_of_sky(camera));
    const double edge = mean_edge(mesh);
    const std::size_t few = rays_of_vertex(edge);
    std::vector<float> shares(mesh.vertices.size());
    parallel_for(shares.size(), 256, [&](std::size_t v) { shares[v] = sky.open_share(static_cast<VertexId>(v), few); });
    for (int round = rounds_of_smoothing(edge); round > 0; --round) shares = smoothed(mesh, shares);
    return shares;
}

}  // namespace meniscus
