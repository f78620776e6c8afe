// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The few features that can be nearest to the points of a small box: what makes many queries cheap.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/accessible_surface_data.h"

namespace meniscus {

/// Lists gathered for one box after the other, reusing their memory.
///
/// They answer for points of the box with |signed distance| < margin. The lists are complete in this sense:
/// `balls` holds every ball that reaches into the box (or comes within margin of its van der Waals sphere),
/// `arcs` every arc whose cell meets the box, `vertices` every vertex within probe + margin of the box.
class LocalFeatures {
public:
    LocalFeatures(const AccessibleSurface& surface, double margin) : surface_(&surface), margin_(margin) {}

    void gather(const Box& box);

    std::span<const std::uint32_t> balls() const { return balls_; }
    std::span<const std::uint32_t> arcs() const { return arcs_; }
    std::span<const std::uint32_t> vertices() const { return vertices_; }

    /// Same as AccessibleSurface::nearest for any point; quick for those the lists answer for.
    NearestFeature nearest(const Vec3& point) const;

private:
    double beyond_balls() const;

    const AccessibleSurface* surface_;
    double margin_;
    std::vector<std::uint32_t> balls_;
    std::vector<std::uint32_t> arcs_;
    std::vector<std::uint32_t> vertices_;
};

/// The nearest feature of each point; quick for points near the surface in spatial order.
///
/// cost     parallel over points
std::vector<NearestFeature> nearest_features(const AccessibleSurface& surface, std::span<const Vec3> points);

}  // namespace meniscus
