// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_light.h"

#include <cmath>
#include <numbers>

namespace meniscus {
namespace {

/// Rays that graze the surface would hit the triangles next to the vertex.
constexpr double kSmallestCosine = 0.08;

/// Rays begin this far above the surface, Å: more than flat triangles stray from it.
constexpr double kLift = 0.05;

constexpr float kUnknown = -1.0F;

/// Evenly spread over the sphere on a spiral (Vogel 1979; Swinbank & Purser 2006).
std::vector<Vec3> spiral_directions(std::size_t count) {
    const double golden_angle = std::numbers::pi * (3.0 - std::sqrt(5.0));
    std::vector<Vec3> directions(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(count);
        const double radius = std::sqrt(1.0 - z * z);
        const double angle = golden_angle * static_cast<double>(i);
        directions[i] = {radius * std::cos(angle), radius * std::sin(angle), z};
    }
    return directions;
}

}  // namespace

SkyLight::SkyLight(const RayScene& scene, const Mesh& mesh, double reach, Side side, std::size_t directions)
    : scene_(scene),
      mesh_(mesh),
      reach_(reach),
      sign_(side == Side::Solvent ? 1.0 : -1.0),
      directions_(spiral_directions(directions)),
      known_(mesh.vertices.size()) {
    for (std::atomic<float>& value : known_) value.store(kUnknown, std::memory_order_relaxed);
}

void SkyLight::take(std::span<const float> shares) {
    for (std::size_t v = 0; v < shares.size(); ++v) known_[v].store(shares[v], std::memory_order_relaxed);
}

/// Two threads may work out the same vertex: they find the same.
float SkyLight::at(VertexId vertex) const {
    float value = known_[vertex].load(std::memory_order_relaxed);
    if (value == kUnknown) {
        value = open_share(vertex);
        known_[vertex].store(value, std::memory_order_relaxed);
    }
    return value;
}

float SkyLight::open_share(VertexId vertex) const {
    const Vec3 normal = sign_ * mesh_.normals[vertex];
    const Vec3 origin = mesh_.vertices[vertex] + kLift * normal;
    double open = 0.0;
    double all = 0.0;
    for (const Vec3& direction : directions_) {
        const double cosine = dot(direction, normal);
        if (cosine < kSmallestCosine) continue;
        all += cosine;
        const std::optional<RayHit> hit = scene_.first_hit({origin, direction}, reach_);
        open += cosine * (hit ? hit->distance / reach_ : 1.0);
    }
    return all > 0.0 ? static_cast<float>(open / all) : 1.0F;
}

}  // namespace meniscus
