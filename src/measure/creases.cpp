// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/creases.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "measure/corrected.h"

namespace meniscus {
namespace {

constexpr double kFaster = 1.35;  // than curvatures tell
constexpr double kNearby = 0.7;   // of a side's length from its middle: there planes have to meet

struct Corner {
    Vec3 point;
    Vec3 normal;
    double away = 0.0;     // principal curvatures, Å^-1: how fast the surface turns away from its normal
    double towards = 0.0;  // and towards it
};

Corner corner_of(const Mesh& mesh, VertexId v, const Vec3& origin) {
    const double mean = mesh.mean_curvatures[v];
    const double root = std::sqrt(std::max(mean * mean - mesh.gaussian_curvatures[v], 0.0));
    return {mesh.vertices[v] - origin, mesh.normals[v], std::max(root + mean, 0.0), std::max(root - mean, 0.0)};
}

// From the middle of a side to where the tangent planes of its ends meet, if there is a crease.
std::optional<Vec3> to_crease(const Corner& a, const Corner& b) {
    const Vec3 chord = b.point - a.point;
    const Vec3 turn = b.normal - a.normal;
    const double expected = dot(turn, chord) > 0.0 ? std::max(a.away, b.away) : std::max(a.towards, b.towards);
    const double least = std::max(kFaster * expected, kLeastTurnPerLength) * norm(chord);
    if (!(norm(turn) > std::max(least, kLeastTurn))) return std::nullopt;
    const double cosine = dot(a.normal, b.normal);
    const double a_above = -0.5 * dot(a.normal, chord);  // its tangent plane over the middle
    const double b_above = 0.5 * dot(b.normal, chord);
    const double scale = 1.0 / (1.0 - cosine * cosine);
    const Vec3 way =
        (scale * (a_above - cosine * b_above)) * a.normal + (scale * (b_above - cosine * a_above)) * b.normal;
    if (!(squared_norm(way) < kNearby * kNearby * squared_norm(chord))) return std::nullopt;
    return way;
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
        const std::optional<Vec3> way = to_crease(a, b);
        any = any || way;
        middles[k] = way ? 0.5 * (a.point + b.point) + *way : arc_middle(a.point, a.normal, b.point, b.normal);
    }
    if (!any) return std::nullopt;
    TriangleSum parts;
    for (std::size_t k = 0; k < 3; ++k) parts.add(corners[k].point, middles[k], middles[(k + 2) % 3]);
    parts.add(middles[0], middles[1], middles[2]);
    return parts;
}

}  // namespace meniscus
