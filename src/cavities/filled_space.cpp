// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "cavities/filled_space.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cavities/choose_pieces.h"

namespace meniscus {
namespace {

// Triangles of the grid are that near to the surface.
constexpr double kNear = 0.5;  // spacings

}  // namespace

FilledSpace::FilledSpace(const FilledCavities& filled, double spacing)
    : filled_(filled), spacing_(spacing), walls_(filled.walls), rest_(filled.rest) {
    for (std::uint32_t t = 0; t < filled_.walls.triangles.size(); ++t) {
        const Triangle& triangle = filled_.walls.triangles[t];
        const std::size_t piece = filled_.walls.components[triangle[0]];
        if (piece >= boxes_.size()) {
            boxes_.resize(piece + 1);
            triangles_.resize(piece + 1);
        }
        boxes_[piece].include(box_of(filled_.walls, triangle));
        triangles_[piece].push_back(t);
    }
}

bool FilledSpace::contains(const Vec3& point) const {
    for (std::size_t piece = 0; piece < boxes_.size(); ++piece)
        if (boxes_[piece].squared_distance(point) == 0.0 && surrounds(piece, point)) return true;
    return false;
}

bool FilledSpace::surrounds(std::size_t piece, const Vec3& point) const {
    double angle = 0.0;
    for (const std::uint32_t t : triangles_[piece])
        angle += solid_angle(point, filled_.walls, filled_.walls.triangles[t]);
    return is_all_round(angle);
}

double FilledSpace::distance(const Vec3& point, double with_cavities) const {
    if (empty()) return with_cavities;
    // In islands, too, walls are as near as the surface with all cavities.
    const bool within = with_cavities > 0.0 && contains(point);
    const double reach = std::max(-with_cavities, 0.0) + kNear * spacing_;
    const bool may_be_near = std::any_of(boxes_.begin(), boxes_.end(),
                                         [&](const Box& box) { return box.squared_distance(point) <= reach * reach; });
    if (!within && !may_be_near) return with_cavities;
    const double to_walls = within ? 0.0 : walls_.distance(filled_.walls, point);
    if (to_walls > reach) return with_cavities;
    const double to_rest = rest_.distance(filled_.rest, point);
    // Solvent beside a thin wall.
    if (!within && with_cavities > 0.0 && to_rest < to_walls) return with_cavities;
    return -to_rest;
}

}  // namespace meniscus
