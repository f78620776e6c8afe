// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/block_units.h"

#include <cmath>

#include "band/block_groups.h"
#include "band/unit_places.h"
#include "geometry/accessible_surface_data.h"

namespace meniscus {
namespace {

constexpr double kAboveOne = 1.0 + 1e-9;  // for rounding
constexpr double kSingleSlack = 1e-5;     // the same in single precision, of the largest length

}  // namespace

double BlockUnits::reach(double spacing, double margin) {
    return margin + kAboveOne * half_diagonal(kUnitEdge, spacing);
}

BlockUnits::BlockUnits(const AccessibleSurface& surface, double spacing, double margin)
    : spacing_(spacing),
      limits_{margin,
              kSingleSlack * (2.0 * kAboveOne * half_diagonal(kUnitEdge, spacing) + margin + surface.data().rho_max)},
      block_(surface, reach(spacing, margin)),
      batch_(surface) {
    const double near_foot = surface.probe() - margin - limits_.slack;
    if (near_foot > 0.0) limits_.near_foot = static_cast<float>(near_foot * near_foot);
    for (std::size_t n = 0; n < kUnitNodes; ++n) {
        const Vec3 step = spacing * (node_steps(n) - to_middle(kUnitEdge));
        set_point(nodes_.offsets, n, spacing * node_steps(n));
        set_point(nodes_.from_middle, n, step);
        nodes_.lengths[n] = static_cast<float>(norm(step));
    }
}

// The distance changes by at most 1 per Å: that of its middle settles a unit that is far from the band.
void BlockUnits::enter_block(const LocalFeatures& around, const Vec3& corner) {
    entered_.corner = corner;
    block_.gather_from(around, box_of_nodes(corner, kBlockEdge, spacing_));
    Vec3 points[kUnits];
    Box box;
    for (std::size_t u = 0; u < kUnits; ++u) {
        points[u] = corner + spacing_ * (unit_steps(u) + to_middle(kUnitEdge));
        box.include(points[u]);
    }
    const Claim all = batch_.start(block_, box, block_.margin());
    if (all == Claim::Open) batch_.find(points);
    for (std::size_t u = 0; u < kUnits; ++u) {
        Middle& middle = entered_.middles[u];
        middle.side = all == Claim::Open ? batch_.claim(u) : all;
        if (all != Claim::Open || !batch_.found(u)) continue;
        middle.distance = batch_.signed_distance(u);
        middle.to_foot = batch_.foot(u) - points[u];
    }
}

BlockUnits::Claim BlockUnits::enter_unit(int unit) {
    entered_.unit = static_cast<std::size_t>(unit);
    const Claim side = entered_.middles[unit].side;
    if (side == Claim::Below || side == Claim::Above) return side;
    const Vec3 corner = entered_.corner + spacing_ * unit_steps(entered_.unit);
    return batch_.start(block_, box_of_nodes(corner, kUnitEdge, spacing_), limits_.margin);
}

KnownSides BlockUnits::screen() const {
    const Middle& middle = entered_.middles[entered_.unit];
    const Vec3& foot = middle.to_foot;
    const PointScreen known{
        .foot = {static_cast<float>(foot.x), static_cast<float>(foot.y), static_cast<float>(foot.z)},
        .near_foot = limits_.near_foot,
        .near_middle = static_cast<float>(std::abs(middle.distance) - limits_.margin - limits_.slack),
        .middle_inside = middle.distance < 0.0};
    return nearest_kernels().screen(known, nodes_.from_middle, nodes_.lengths);
}

void BlockUnits::search(std::span<const std::uint32_t> nodes) {
    const Vec3 corner = entered_.corner + spacing_ * unit_steps(entered_.unit);
    const auto place = [&](std::size_t i, std::size_t n) {
        set_point(points_, i, corner + get_point(nodes_.offsets, n));
    };
    if (nodes.size() == kUnitNodes)
        for (std::size_t n = 0; n < kUnitNodes; ++n) place(n, n);
    else
        for (std::size_t i = 0; i < nodes.size(); ++i) place(i, nodes[i]);
    batch_.find(points_, nodes.size());
}

}  // namespace meniscus
