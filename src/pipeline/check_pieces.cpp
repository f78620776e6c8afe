// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "meniscus/surface.h"

namespace meniscus {
namespace {

constexpr double kResolved = 1.5;  // spacings: pieces with a larger inscribed radius must be there

struct DeepPoint {
    Vec3 position;
    double radius;
    bool inside;
};

DeepPoint deepest_point(const SurfaceComponent& piece, const Atoms& atoms) {
    if (piece.kind == ComponentKind::Cavity) return {piece.inscribed_centre, piece.inscribed_radius, false};
    const std::uint32_t largest =
        *std::max_element(piece.atoms.begin(), piece.atoms.end(),
                          [&](std::uint32_t a, std::uint32_t b) { return atoms.radii[a] < atoms.radii[b]; });
    return {atoms.centres[largest], atoms.radii[largest], true};
}

// By the value there, or beyond the band by how a ray first crosses the surface.
bool is_inside(const LevelSet& level_set, const Vec3& point) {
    const double value = level_set.value(point);
    if (!std::isnan(value)) return value < 0.0;
    const Vec3 direction{0.5377, 0.6181, 0.5737};  // no symmetry axis of anything
    const double distance = level_set.intersect(point, direction);
    if (std::isinf(distance)) return false;
    const Vec3 crossing = point + (distance / norm(direction)) * direction;
    return dot(level_set.sample(crossing).gradient, direction) > 0.0;
}

}  // namespace

Check check_pieces(const Surface& surface, const Measures& measured, const Atoms& atoms) {
    double wrong = 0.0;
    for (const SurfaceComponent& piece : measured.components) {
        const DeepPoint point = deepest_point(piece, atoms);
        if (point.radius <= kResolved * surface.options.spacing) continue;
        if (is_inside(*surface.level_set, point.position) != point.inside) wrong += 1.0;
    }
    return {"pieces", wrong == 0.0, wrong, 0.0};
}

}  // namespace meniscus
