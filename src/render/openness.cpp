// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/openness.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/golden_angle.h"
#include "core/parallel.h"
#include "render/depth_layers.h"
#include "render/sky_reach.h"

namespace meniscus {
namespace {

/// Axes along which the mesh is projected: each gives two directions of the sky.
constexpr std::size_t kAxes = 16;
constexpr std::size_t kAtOnce = 8;  // so many maps are in memory

/// Pixels are at least so wide, Å: a quarter of an atom, since what is smaller is blurred anyway.
constexpr double kFinestPixel = 0.4;

/// Vertices are lifted by so many pixels, so that the surface around a vertex does not hide the sky from it.
constexpr double kLift = 1.0;

/// Directions that graze the surface would meet the triangles around the vertex.
constexpr float kSmallestCosine = 0.1F;

/// A vertex looks along so many axes per Å² of the surface around it. Its neighbours look along the others, and
/// smoothing brings together what they see.
constexpr double kAxesPerArea = 80.0;
constexpr double kFewestAxes = 6.0;

/// Rounds of smoothing times the square of an edge, Å²: they blur what single directions hide, however fine the mesh.
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

/// Every so many vertices look along the same axes. Twice as many equilateral triangles as vertices cover the surface.
std::size_t stride_of_axes(double edge) {
    const double area = 0.5 * std::numbers::sqrt3 * edge * edge;
    const double axes = std::clamp(kAxesPerArea * area, kFewestAxes, double{kAxes});
    return static_cast<std::size_t>(std::round(kAxes / axes));
}

/// Spread evenly over a half of the sphere, on a spiral (Vogel 1979).
std::array<Vec3, kAxes> spread_axes() {
    std::array<Vec3, kAxes> axes;
    for (std::size_t i = 0; i < kAxes; ++i) {
        const double height = (static_cast<double>(i) + 0.5) / double{kAxes};
        const double turn = kGoldenAngle * static_cast<double>(i);
        const double radius = std::sqrt(1.0 - height * height);
        axes[i] = {radius * std::cos(turn), radius * std::sin(turn), height};
    }
    return axes;
}

/// How much of the sky a vertex sees, of how much that has been looked at, weighted by the cosine to the normal.
struct Seen {
    float open = 0.0F;
    float all = 0.0F;
};

}  // namespace

std::vector<float> openness(const Mesh& mesh) {
    const double edge = mean_edge(mesh);
    const double pixel = std::max(kFinestPixel, edge);
    const auto reach = static_cast<float>(reach_of_sky(Camera(mesh.vertices, {})));
    const std::array<Vec3, kAxes> axes = spread_axes();
    const std::size_t stride = stride_of_axes(edge);
    std::vector<Seen> seen(mesh.vertices.size());
    for (std::size_t first = 0; first < kAxes; first += kAtOnce) {
        std::vector<std::optional<DepthLayers>> maps(kAtOnce);
        parallel_for(kAtOnce, 1, [&](std::size_t i) { maps[i].emplace(mesh, axes[first + i], pixel); });
        parallel_for(seen.size(), 1024, [&](std::size_t v) {
            const Vec3 normal = mesh.normals[v];
            const Vec3 point = mesh.vertices[v] + (kLift * pixel) * normal;
            for (std::size_t i = (v + first) % stride; i < kAtOnce; i += stride) {
                const auto cosine = static_cast<float>(dot(normal, axes[first + i]));
                if (std::abs(cosine) < kSmallestCosine) continue;
                const DepthLayers::Gaps gaps = maps[i]->gaps(point);
                const float gap = cosine > 0.0F ? gaps.above : gaps.below;
                seen[v].open += std::abs(cosine) * std::min(gap / reach, 1.0F);
                seen[v].all += std::abs(cosine);
            }
        });
    }
    std::vector<float> shares;
    shares.reserve(seen.size());
    for (const Seen& s : seen) shares.push_back(s.all > 0.0F ? s.open / s.all : 1.0F);
    for (int round = rounds_of_smoothing(edge); round > 0; --round) shares = smoothed(mesh, shares);
    return shares;
}

}  // namespace meniscus
