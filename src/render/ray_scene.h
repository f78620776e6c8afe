// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where rays hit a mesh. The only pair of files that names Embree.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "meniscus/mesh.h"
#include "render/half_space.h"

namespace meniscus {

struct Ray {
    Vec3 origin;
    Vec3 direction;  ///< unit vector
};

/// A point of a triangle.
struct RayHit {
    double distance = 0.0;  ///< along the ray, Å
    std::uint32_t triangle = 0;
    double u = 0.0;  ///< share of the triangle's second corner
    double v = 0.0;  ///< share of its third corner; the first has the rest
};

/// A mesh prepared for rays. Hits are the same for any number of threads.
class RayScene {
public:
    /// mesh     with at least one triangle; not needed later
    /// throws   std::runtime_error if Embree cannot work here
    /// cost     O(n log n); copies share what is prepared
    explicit RayScene(const Mesh& mesh);

    /// The same mesh where nothing is hit that lies outside of what is kept.
    RayScene cut(const HalfSpace& kept) const;

    /// The nearest triangle that a ray hits within `reach` (Å), seen from either side. From several threads at once.
    std::optional<RayHit> first_hit(const Ray& ray, double reach) const;

    /// Rays that first_hits() takes.
    static constexpr std::size_t kTogether = 16;

    /// The same of several rays that run close to each other, up to kTogether, at a third of the cost.
    /// hits     one for each ray
    void first_hits(std::span<const Ray> rays, double reach, std::span<std::optional<RayHit>> hits) const;

private:
    struct Handles;
    Interval kept_part(const Ray& ray, double reach) const;

    std::shared_ptr<const Handles> handles_;
    Vec3 centre_;
    std::optional<HalfSpace> kept_;
};

}  // namespace meniscus
