// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

#include "core/golden_angle.h"
#include "core/mix_bits.h"
#include "core/perpendicular.h"
#include "render/sky_reach.h"

namespace meniscus {
namespace {

/// Rays that graze the surface would hit the triangles next to the vertex.
constexpr double kSmallestCosine = 0.08;

/// Rays begin this far above the surface, Å: more than flat triangles stray from it.
constexpr double kLift = 0.05;

constexpr float kUnknown = -1.0F;

/// Rounds of smoothing times the square of an edge, Å²: they blur what is far smaller than an atom.
constexpr double kSkyBlur = 0.2;

/// Rays of each vertex by rounds of smoothing, which take the mean of 1, 7 and 19 of them.
constexpr std::array<std::size_t, 3> kRays{96, 16, 10};

const double kTurnCosine = std::cos(kGoldenAngle);
const double kTurnSine = std::sin(kGoldenAngle);

std::size_t rounds_of_smoothing(const Mesh& mesh) {
    const double edge = mean_edge(mesh);
    return static_cast<std::size_t>(std::min(std::round(kSkyBlur / (edge * edge)), double{kRays.size() - 1}));
}

}  // namespace

/// The rays are spread evenly in the plane beneath them, on a spiral (Vogel 1979), and so by the cosine over the sky.
float SkyRays::open_share(VertexId vertex, std::size_t rays) const {
    const Vec3 up = sign_ * mesh_.normals[vertex];
    if (up == Vec3{}) return 1.0F;  // of no triangle that has an area
    const Vec3 origin = mesh_.vertices[vertex] + kLift * up;
    const std::uint64_t chance = mix_bits((std::uint64_t{vertex} + 1) * kMixIncrement);
    const double turn = std::numbers::pi * signed_unit(chance);
    const double start = 0.5 + 0.5 * signed_unit(mix_bits(chance + kMixIncrement));
    const double step = (1.0 - kSmallestCosine * kSmallestCosine) / static_cast<double>(rays);
    const Vec3 east = perpendicular(up);
    Vec3 level = std::cos(turn) * east + std::sin(turn) * cross(up, east);
    double open = 0.0;
    for (std::size_t i = 0; i < rays; ++i) {
        const double squared_sine = step * (static_cast<double>(i) + start);
        const Vec3 direction = std::sqrt(squared_sine) * level + std::sqrt(1.0 - squared_sine) * up;
        const std::optional<RayHit> hit = scene_.first_hit({origin, direction}, reach_);
        open += hit ? hit->distance / reach_ : 1.0;
        level = kTurnCosine * level + kTurnSine * cross(up, level);
    }
    return static_cast<float>(open / static_cast<double>(rays));
}

SkyLight::Prepared::Prepared(const Mesh& mesh) : rounds(rounds_of_smoothing(mesh)) {
    for (std::size_t round = 0; round <= rounds; ++round)
        for (std::atomic<float>& share : known.emplace_back(mesh.vertices.size()))
            share.store(kUnknown, std::memory_order_relaxed);
    if (rounds == 0) return;
    begins.assign(mesh.vertices.size() + 1, 0);
    for (const Triangle& t : mesh.triangles)
        for (const VertexId v : t) ++begins[v + std::size_t{1}];
    std::partial_sum(begins.begin(), begins.end(), begins.begin());
    neighbours.resize(begins.back());
    std::vector<std::size_t> next(begins.begin(), begins.end() - 1);
    for (const auto& [a, b, c] : mesh.triangles) {
        neighbours[next[a]++] = b;
        neighbours[next[b]++] = c;
        neighbours[next[c]++] = a;
    }
}

std::span<const VertexId> SkyLight::Prepared::around(VertexId vertex) const {
    return std::span(neighbours).subspan(begins[vertex], begins[vertex + std::size_t{1}] - begins[vertex]);
}

SkyLight::Prepared& SkyLight::prepare() const {
    std::call_once(preparation_, [this] {
        owned_ = std::make_unique<Prepared>(rays_.mesh());
        prepared_.store(owned_.get(), std::memory_order_release);
    });
    return *owned_;
}

/// Two threads may work out the same vertex: they find the same.
float SkyLight::smoothed(Prepared& prepared, VertexId vertex, std::size_t rounds) const {
    std::atomic<float>& known = prepared.known[rounds][vertex];
    float share = known.load(std::memory_order_relaxed);
    if (share == kUnknown) {
        share =
            rounds > 0 ? mean_around(prepared, vertex, rounds - 1) : rays_.open_share(vertex, kRays[prepared.rounds]);
        known.store(share, std::memory_order_relaxed);
    }
    return share;
}

float SkyLight::mean_around(Prepared& prepared, VertexId vertex, std::size_t rounds) const {
    const std::span<const VertexId> around = prepared.around(vertex);
    float sum = smoothed(prepared, vertex, rounds);
    for (const VertexId v : around) sum += smoothed(prepared, v, rounds);
    return sum / static_cast<float>(around.size() + 1);
}

}  // namespace meniscus
