// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/openness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

#include "core/mix_bits.h"
#include "core/parallel.h"
#include "render/camera.h"
#include "render/scene.h"

namespace meniscus {
namespace {

/// Edge of the cells of which one vertex looks at the sky, Å: the sky changes little over half an atom.
constexpr double kCell = 1.0;

constexpr std::size_t kFewDirections = 64;

/// Rounds of smoothing times the square of an edge, Å²: they blur the cells, however fine the mesh.
constexpr double kBlur = 0.4;
constexpr double kMostRounds = 20.0;

/// Place in the grid, and the octant of the normal.
using Cell = std::array<std::int64_t, 4>;

Cell cell_of(const Vec3& point, const Vec3& normal) {
    const auto along = [](double x) { return static_cast<std::int64_t>(std::floor(x / kCell)); };
    const int octant = (normal.x < 0.0 ? 1 : 0) + (normal.y < 0.0 ? 2 : 0) + (normal.z < 0.0 ? 4 : 0);
    return {along(point.x), along(point.y), along(point.z), octant};
}

struct CellHash {
    std::size_t operator()(const Cell& cell) const {
        std::uint64_t hash = 0;
        for (const std::int64_t part : cell) hash = mix_bits(hash ^ static_cast<std::uint64_t>(part));
        return hash;
    }
};

/// Vertices that look at the sky, and of every vertex the one that does so for it.
struct Lookouts {
    std::vector<VertexId> vertices{};
    std::vector<std::uint32_t> of_vertex{};
};

Lookouts choose_lookouts(const Mesh& mesh) {
    Lookouts lookouts;
    std::unordered_map<Cell, std::uint32_t, CellHash> cells;
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const auto next = static_cast<std::uint32_t>(lookouts.vertices.size());
        const auto [cell, is_new] = cells.try_emplace(cell_of(mesh.vertices[v], mesh.normals[v]), next);
        if (is_new) lookouts.vertices.push_back(static_cast<VertexId>(v));
        lookouts.of_vertex.push_back(cell->second);
    }
    return lookouts;
}

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

double mean_edge(const Mesh& mesh) {
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) sum += norm(mesh.vertices[t[1]] - mesh.vertices[t[0]]);
    return sum / static_cast<double>(mesh.triangles.size());
}

int rounds_of_smoothing(const Mesh& mesh) {
    const double edge = mean_edge(mesh);
    return static_cast<int>(std::clamp(std::round(kBlur / (edge * edge)), 1.0, kMostRounds));
}

}  // namespace

std::vector<float> openness(const Mesh& mesh, const RayScene& rays) {
    const Camera camera(mesh.vertices, {});
    const SkyLight sky(rays, mesh, reach_of_sky(camera), SkyLight::Side::Solvent, kFewDirections);
    const Lookouts lookouts = choose_lookouts(mesh);
    std::vector<float> seen(lookouts.vertices.size());
    parallel_for(seen.size(), 256, [&](std::size_t i) { seen[i] = sky.at(lookouts.vertices[i]); });
    std::vector<float> shares(mesh.vertices.size());
    for (std::size_t v = 0; v < shares.size(); ++v) shares[v] = seen[lookouts.of_vertex[v]];
    for (int round = rounds_of_smoothing(mesh); round > 0; --round) shares = smoothed(mesh, shares);
    return shares;
}

}  // namespace meniscus
