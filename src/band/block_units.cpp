// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/block_units.h"

#include <cmath>
#include <numbers>

#include "band/block_groups.h"
#include "geometry/accessible_surface_data.h"

namespace meniscus {
namespace {

constexpr double kAboveOne = 1.0 + 1e-9;  // for rounding
constexpr double kSingleSlack = 1e-5;     // the same in single precision, of the largest length

// Of a unit's middle from its first node, in spacings.
constexpr double kHalfEdge = 0.5 * (kUnitEdge - 1);
constexpr Vec3 kToMiddle{kHalfEdge, kHalfEdge, kHalfEdge};

// Of a unit's first node from the block's, in spacings.
Vec3 unit_steps(int unit) { return kUnitEdge * Vec3{1.0 * (unit & 1), 1.0 * (unit >> 1 & 1), 1.0 * (unit >> 2)}; }

// Of a node of a unit from its first one, in spacings.
Vec3 node_offset(int n) {
    const int y = n / kUnitEdge % kUnitEdge;
    const int z = n / (kUnitEdge * kUnitEdge);
    return {static_cast<double>(n % kUnitEdge), static_cast<double>(y), static_cast<double>(z)};
}

}  // namespace

BlockUnits::BlockUnits(const AccessibleSurface& surface, double spacing, double margin)
    : spacing_(spacing),
      margin_(margin),
      half_unit_(kAboveOne * 0.5 * std::numbers::sqrt3 * (kUnitEdge - 1) * spacing),
      slack_(kSingleSlack * (2.0 * half_unit_ + margin + surface.data().rho_max)),
      around_(surface, margin + half_unit_),
      part_(surface, margin + half_unit_),
      block_(surface, margin + half_unit_),
      batch_(surface) {
    const double near_foot = surface.probe() - margin - slack_;
    if (near_foot > 0.0) near_foot_ = static_cast<float>(near_foot * near_foot);
    for (int n = 0; n < kUnitNodes; ++n) {
        const auto i = static_cast<std::size_t>(n);
        const Vec3 offset = spacing * node_offset(n);
        const Vec3 step = spacing * (node_offset(n) - kToMiddle);
        offsets_.x[i] = offset.x;
        offsets_.y[i] = offset.y;
        offsets_.z[i] = offset.z;
        steps_.x[i] = static_cast<float>(step.x);
        steps_.y[i] = static_cast<float>(step.y);
        steps_.z[i] = static_cast<float>(step.z);
        lengths_[i] = static_cast<float>(norm(step));
    }
}

// The distance changes by at most 1 per Å: that of its middle settles a unit that is far from the band.
void BlockUnits::enter_block(const Vec3& corner) {
    corner_ = corner;
    block_.gather_from(part_, box_of_nodes(corner, kBlockEdge, spacing_));
    Vec3 points[kUnits];
    Box box;
    for (int u = 0; u < kUnits; ++u) {
        points[u] = corner + spacing_ * (unit_steps(u) + kToMiddle);
        box.include(points[u]);
    }
    const Claim all = batch_.start(block_, box, block_.margin());
    if (all == Claim::Open) batch_.find(points);
    for (std::size_t u = 0; u < kUnits; ++u) {
        middles_[u].side = all == Claim::Open ? batch_.claim(u) : all;
        if (all != Claim::Open || !batch_.found(u)) continue;
        middles_[u].distance = batch_.signed_distance(u);
        middles_[u].to_foot = batch_.foot(u) - points[u];
    }
}

BlockUnits::Claim BlockUnits::enter_unit(int unit) {
    unit_ = unit;
    const Claim side = middles_[unit].side;
    if (side == Claim::Below || side == Claim::Above) return side;
    return batch_.start(block_, box_of_nodes(corner_ + spacing_ * unit_steps(unit), kUnitEdge, spacing_), margin_);
}

KnownSides BlockUnits::screen() const {
    const Middle& middle = middles_[unit_];
    const Vec3& foot = middle.to_foot;
    const PointScreen known{
        .foot = {static_cast<float>(foot.x), static_cast<float>(foot.y), static_cast<float>(foot.z)},
        .near_foot = near_foot_,
        .near_middle = static_cast<float>(std::abs(middle.distance) - margin_ - slack_),
        .middle_inside = middle.distance < 0.0};
    return nearest_kernels().screen(known, steps_, lengths_);
}

void BlockUnits::search(std::span<const std::uint32_t> nodes) {
    const Vec3 corner = corner_ + spacing_ * unit_steps(unit_);
    const auto place = [&](std::size_t i, std::size_t n) {
        points_.x[i] = corner.x + offsets_.x[n];
        points_.y[i] = corner.y + offsets_.y[n];
        points_.z[i] = corner.z + offsets_.z[n];
    };
    if (nodes.size() == kUnitNodes)
        for (std::size_t n = 0; n < kUnitNodes; ++n) place(n, n);
    else
        for (std::size_t i = 0; i < nodes.size(); ++i) place(i, nodes[i]);
    batch_.find(points_, nodes.size());
}

}  // namespace meniscus
