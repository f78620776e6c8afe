// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/creases.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "core/tangent_planes.h"
#include "measure/corrected.h"
#include "meniscus/curvature.h"

namespace meniscus {
namespace {

constexpr double kFaster = 1.35;  // than curvatures tell
constexpr double kNearby = 0.7;   // of a side's length from its middle: there planes have to meet

struct Corner {
    Vec3 point;
    Vec3 normal;
    PrincipalCurvatures curvatures;
};

Corner corner_of(const Mesh& mesh, VertexId v, const Vec3& origin) {
    return {mesh.vertices[v] - origin, mesh.normals[v],
            principal_curvatures(mesh.mean_curvatures[v], mesh.gaussian_curvatures[v])};
}

// How fast the surface turns at either end of a side, away from its normals or towards them, Å^-1.
double expected_turn(const Corner& a, const Corner& b, bool away) {
    const auto turn = [away](const PrincipalCurvatures& k) { return away ? k.largest : -k.smallest; };
    return std::max({turn(a.curvatures), turn(b.curvatures), 0.0});
}

// Where the tangent planes of both ends of a side meet, if there is a crease.
std::optional<Vec3> place_on_crease(const Corner& a, const Corner& b) {
    const Vec3 chord = b.point - a.point;
    const Vec3 turn = b.normal - a.normal;
    const double expected = expected_turn(a, b, dot(turn, chord) > 0.0);
    const double least = std::max(kFaster * expected, kLeastTurnPerLength) * norm(chord);
    if (!(norm(turn) > std::max(least, kLeastTurn))) return std::nullopt;
    const Vec3 middle = 0.5 * (a.point + b.point);
    const Vec3 place = meeting_of_planes(a.point, a.normal, b.point, b.normal, middle);
    if (!(squared_norm(place - middle) < kNearby * kNearby * squared_norm(chord))) return std::nullopt;
    return place;
}

}  // namespace

bool knows_creases(const Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    return mesh.normals.size() == n && mesh.mean_curvatures.size() == n && mesh.gaussian_curvatures.size() == n;
}

std::optional<TriangleSum> parts_over_crease(const Mesh& mesh, const Triangle& triangle, const Vec3& origin) {
    std::array<Corner, 3> corners;
    for (std::size_t k = 0; k < 3; ++k) corners[k] = corner_of(mesh, triangle[k], origin);
    std::array<Vec3, 3> middles;  // of the sides from corner k to the next
    bool any = false;
    for (std::size_t k = 0; k < 3; ++k) {
        const Corner& a = corners[k];
        const Corner& b = corners[(k + 1) % 3];
        const std::optional<Vec3> place = place_on_crease(a, b);
        any = any || place;
        middles[k] = place ? *place : arc_middle(a.point, a.normal, b.point, b.normal);
    }
    if (!any) return std::nullopt;
    TriangleSum parts;
    for (std::size_t k = 0; k < 3; ++k) parts.add(corners[k].point, middles[k], middles[(k + 2) % 3]);
    parts.add(middles[0], middles[1], middles[2]);
    return parts;
}

}  // namespace meniscus
