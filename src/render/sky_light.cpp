// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>

#include "core/mix_bits.h"

namespace meniscus {
namespace {

/// Rays that graze the surface would hit the triangles next to the vertex.
constexpr double kSmallestCosine = 0.08;

/// Rays begin this far above the surface, Å: more than flat triangles stray from it.
constexpr double kLift = 0.05;

constexpr float kUnknown = -1.0F;

/// Rounds of smoothing times the square of an edge, Å²: they blur what is far smaller than an atom.
constexpr double kBlur = 0.2;

/// Rays of each vertex by rounds of smoothing, which take the mean of 1, 7 and 19 of them.
constexpr std::array<std::size_t, 3> kRays{96, 16, 10};

const double kGoldenAngle = std::numbers::pi * (3.0 - std::sqrt(5.0));

Vec3 perpendicular_to(const Vec3& v) {
    return normalised(cross(v, std::abs(v.x) < 0.5 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
}

std::size_t rounds_of_smoothing(const Mesh& mesh) {
    const double edge = mean_edge(mesh);
    return static_cast<std::size_t>(std::min(std::round(kBlur / (edge * edge)), double{kRays.size() - 1}));
}

}  // namespace

double mean_edge(const Mesh& mesh) {
    double sum = 0.0;
    for (const Triangle& t : mesh.triangles) sum += norm(mesh.vertices[t[1]] - mesh.vertices[t[0]]);
    return sum / static_cast<double>(mesh.triangles.size());
}

/// The rays are spread evenly in the plane beneath them, on a spiral (Vogel 1979), and so by the cosine over the sky.
float SkyRays::open_share(VertexId vertex, std::size_t rays) const {
    const Vec3 up = sign_ * mesh_.normals[vertex];
    if (up == Vec3{}) return 1.0F;  // of no triangle that has an area
    const Vec3 east = perpendicular_to(up);
    const Vec3 north = cross(up, east);
    const Vec3 origin = mesh_.vertices[vertex] + kLift * up;
    const std::uint64_t chance = mix_bits((std::uint64_t{vertex} + 1) * kMixIncrement);
    const double turn = std::numbers::pi * signed_unit(chance);
    const double start = 0.5 + 0.5 * signed_unit(mix_bits(chance + kMixIncrement));
    const double step = (1.0 - kSmallestCosine * kSmallestCosine) / static_cast<double>(rays);
    double open = 0.0;
    for (std::size_t i = 0; i < rays; ++i) {
        const auto number = static_cast<double>(i);
        const double squared_sine = step * (number + start);
        const double angle = turn + kGoldenAngle * number;
        const Vec3 level = std::cos(angle) * east + std::sin(angle) * north;
        const Vec3 direction = std::sqrt(squared_sine) * level + std::sqrt(1.0 - squared_sine) * up;
        const std::optional<RayHit> hit = scene_.first_hit({origin, direction}, reach_);
        open += hit ? hit->distance / reach_ : 1.0;
    }
    return static_cast<float>(open / static_cast<double>(rays));
}

void SkyLight::prepare() const {
    std::call_once(preparation_, [this] {
        rounds_ = rounds_of_smoothing(rays_.mesh());
        for (std::size_t round = 0; round <= rounds_; ++round)
            for (std::atomic<float>& share : known_.emplace_back(rays_.mesh().vertices.size()))
                share.store(kUnknown, std::memory_order_relaxed);
        if (rounds_ > 0) list_neighbours();
        is_prepared_.store(true, std::memory_order_release);
    });
}

void SkyLight::list_neighbours() const {
    const Mesh& mesh = rays_.mesh();
    neighbour_begin_.assign(mesh.vertices.size() + 1, 0);
    for (const Triangle& t : mesh.triangles)
        for (const VertexId v : t) ++neighbour_begin_[v + std::size_t{1}];
    std::partial_sum(neighbour_begin_.begin(), neighbour_begin_.end(), neighbour_begin_.begin());
    neighbours_.resize(neighbour_begin_.back());
    std::vector<std::size_t> next(neighbour_begin_.begin(), neighbour_begin_.end() - 1);
    for (const auto& [a, b, c] : mesh.triangles) {
        neighbours_[next[a]++] = b;
        neighbours_[next[b]++] = c;
        neighbours_[next[c]++] = a;
    }
}

std::span<const VertexId> SkyLight::neighbours(VertexId vertex) const {
    const std::size_t begin = neighbour_begin_[vertex];
    return std::span(neighbours_).subspan(begin, neighbour_begin_[vertex + std::size_t{1}] - begin);
}

/// Two threads may work out the same vertex: they find the same.
float SkyLight::smoothed(VertexId vertex, std::size_t rounds) const {
    std::atomic<float>& known = known_[rounds][vertex];
    float share = known.load(std::memory_order_relaxed);
    if (share == kUnknown) {
        share = rounds > 0 ? mean_around(vertex, rounds - 1) : rays_.open_share(vertex, kRays[rounds_]);
        known.store(share, std::memory_order_relaxed);
    }
    return share;
}

float SkyLight::mean_around(VertexId vertex, std::size_t rounds) const {
    const std::span<const VertexId> around = neighbours(vertex);
    float sum = smoothed(vertex, rounds);
    for (const VertexId v : around) sum += smoothed(v, rounds);
    return sum / static_cast<float>(around.size() + 1);
}

}  // namespace meniscus
