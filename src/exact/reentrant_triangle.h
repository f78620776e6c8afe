// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The spherical triangle that a probe position spans between its three atoms, and which other probes may reach into it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/accessible_surface_data.h"
#include "space/box_tree.h"

namespace meniscus {

/// The triangle of one vertex before other probes trim it, on the unit sphere of directions from the probe's centre.
/// Side k runs from corner k to the next one.
struct ReentrantTriangle {
    static constexpr std::size_t kSides = 3;

    ReentrantTriangle() = default;
    ReentrantTriangle(const AccessibleSurface::Data& data, const SasVertex& vertex);

    /// Whether the cap {n : n·axis > t} is known to lie beyond the sides, by more than rounding.
    bool is_missed_by(const Vec3& axis, double t) const;
    /// Whether a triangle that no other probe reaches is all there is, rounding or not: no sliver and no hemisphere.
    bool is_wide() const;

    std::array<Vec3, kSides> corners;      ///< towards the atoms
    std::array<Vec3, kSides> sides;        ///< axes of the hemispheres beyond the sides
    std::array<double, kSides> lengths{};  ///< of the sides, radian
    double solid_angle = 0.0;
    Vec3 middle;                ///< direction of the corners' mean
    double cos_farthest = 0.0;  ///< of the angle from the middle to the farthest corner
    bool out_of_reach = false;  ///< of any other probe: it lies before the plane of its atoms' centres
    bool within_cap = false;    ///< the triangle lies within the cap of that angle, which is no hemisphere

private:
    bool lies_between(const std::array<Vec3, kSides>& to_atoms, double probe) const;
    double cos_nearest(const Vec3& axis, const std::array<double, kSides>& beyond) const;
};

/// The triangles of vertices one after the other and the probes near them. Neighbours share a search: vertices are
/// numbered in spatial order.
class NearProbes {
public:
    explicit NearProbes(const AccessibleSurface::Data& data) : data_(data) {}

    /// Goes to a vertex.
    void visit(std::uint32_t v);
    /// Of the vertex visited.
    const ReentrantTriangle& triangle() const { return triangles_[visited_ - begin_]; }
    /// Other vertices, in rising order: all whose probes reach into the triangle, and few others; none if it is out of
    /// reach.
    std::span<const std::uint32_t> reaching() const { return reaching_; }

private:
    static constexpr std::uint32_t kGroup = 16;

    void search_around(std::uint32_t v);
    void list_near(const Box& room);
    void choose_reaching();

    const AccessibleSurface::Data& data_;
    std::uint32_t begin_ = 0;  // vertices that near_ is complete for
    std::uint32_t end_ = 0;
    std::uint32_t visited_ = 0;
    std::array<ReentrantTriangle, kGroup> triangles_;
    std::vector<std::uint32_t> near_;
    struct {
        std::vector<float> x;
        std::vector<float> y;
        std::vector<float> z;
    } places_;  // of those near, from the first vertex of the group
    std::vector<std::uint32_t> reaching_;
};

}  // namespace meniscus
