// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/patch.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/elementary.h"
#include "mesh/corner_numbers.h"
#include "remesh/self_intersections.h"
#include "remesh/working_mesh.h"
#include "space/box_tree.h"

namespace meniscus {
namespace {

bool has_corner(const Triangle& t, VertexId v) { return t[0] == v || t[1] == v || t[2] == v; }

std::array<Vec3, 3> corners_of(const Patch& patch, const Triangle& t) {
    return {patch.at(t[0]), patch.at(t[1]), patch.at(t[2])};
}

double cosine_between(const Vec3& a, const Vec3& b) {
    const double product = squared_norm(a) * squared_norm(b);
    return product > 0.0 ? dot(a, b) / std::sqrt(product) : -1.0;
}

double facing_of(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c) {
    return cosine_between(area_vector(a.position, b.position, c.position), a.normal + b.normal + c.normal);
}

// Empty for a removed triangle: it overlaps nothing.
Box box_of(const Patch& patch, std::size_t triangle) {
    Box box;
    if (patch.has(triangle))
        for (const VertexId v : patch.triangles[triangle]) box.include(patch.at(v));
    return box;
}

HeldTriangle held_triangle(const Patch& patch, const Triangle& t) { return {t, corners_of(patch, t)}; }

bool meets(const HeldTriangle& held, const Patch& patch, const Triangle& t) {
    return held.meeting(t, corners_of(patch, t)).has_value();
}

}  // namespace

double tangent_of_smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double ab = squared_norm(b - a);
    const double bc = squared_norm(c - b);
    const double ca = squared_norm(a - c);
    // The smallest angle lies opposite the shortest side.
    const double product = 0.5 * (ab + bc + ca) - std::min({ab, bc, ca});
    return product > 0.0 ? norm(area_vector(a, b, c)) / product : 0.0;
}

double tangent_of_degrees(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return elementary::sin(angle) / elementary::cos(angle);
}

std::vector<std::size_t> Patch::star(VertexId v) const {
    std::vector<std::size_t> found;
    for_each_corner(v, [&](std::size_t t, std::size_t /*corner*/) { found.push_back(t); });
    return found;
}

double goodness_of(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c, double shortest) {
    const Vec3 area = area_vector(a.position, b.position, c.position);
    if (dot(area, a.normal) < 0.0 && dot(area, b.normal) < 0.0 && dot(area, c.normal) < 0.0) return facing_of(a, b, c);
    const double tangent = tangent_of_smallest_angle(a.position, b.position, c.position);
    const double length2 = std::min({squared_norm(b.position - a.position), squared_norm(c.position - b.position),
                                     squared_norm(a.position - c.position)});
    constexpr double kOfShortEdges = 0.08;  // below the tangent of 5 degrees
    return length2 < shortest * shortest ? std::min(tangent, kOfShortEdges * std::sqrt(length2) / shortest) : tangent;
}

double Patch::goodness(const Triangle& triangle, double shortest) const {
    return goodness_of(points[triangle[0]], points[triangle[1]], points[triangle[2]], shortest);
}

std::optional<Patch::Sides> Patch::sides(VertexId a, VertexId b) const {
    Sides found;
    int count = 0;
    for_each_corner(a, [&](std::size_t t, std::size_t k) {
        const VertexId next = triangles[t][(k + 1) % 3];
        const VertexId last = triangles[t][(k + 2) % 3];
        if (next == b) {
            found.left = t;
            found.left_corner = last;
            ++count;
        } else if (last == b) {
            found.right = t;
            found.right_corner = next;
            ++count;
        }
    });
    if (count != 2) return std::nullopt;
    return found;
}

bool Patch::flip(VertexId a, VertexId b) {
    const std::optional<Sides> edge = sides(a, b);
    if (!edge) return false;
    const VertexId c = edge->left_corner;
    const VertexId d = edge->right_corner;
    if (c == d || sides(c, d) || star(a).size() <= 3 || star(b).size() <= 3) return false;
    triangles[edge->left] = {d, c, a};
    triangles[edge->right] = {c, d, b};
    return true;
}

bool Patch::collapse(VertexId a, VertexId b) {
    const std::optional<Sides> edge = sides(a, b);
    if (!edge) return false;
    const VertexId c = edge->left_corner;
    const VertexId d = edge->right_corner;
    if (c == d || star(c).size() <= 3 || star(d).size() <= 3) return false;
    const std::vector<std::size_t> round_a = star(a);
    const std::vector<std::size_t> round_b = star(b);
    const auto touches = [&](const std::vector<std::size_t>& star, VertexId v) {
        return std::any_of(star.begin(), star.end(), [&](std::size_t t) { return has_corner(triangles[t], v); });
    };
    // The link condition: no other vertex is a neighbour of both.
    for (const std::size_t t : round_a)
        for (const VertexId v : triangles[t])
            if (v != a && v != b && v != c && v != d && touches(round_b, v)) return false;
    for (const std::size_t t : round_a) std::replace(triangles[t].begin(), triangles[t].end(), a, b);
    triangles[edge->left] = {b, b, b};
    triangles[edge->right] = {b, b, b};
    return true;
}

bool Patch::split(VertexId a, VertexId b) {
    const std::optional<Sides> edge = sides(a, b);
    if (!edge) return false;
    const auto middle = static_cast<VertexId>(points.size());
    const Vec3 normal = points[a].normal + points[b].normal;
    points.push_back({0.5 * (at(a) + at(b)), squared_norm(normal) > 0.0 ? normalised(normal) : points[a].normal, 0.0});
    const VertexId c = edge->left_corner;
    const VertexId d = edge->right_corner;
    triangles[edge->left] = {a, middle, c};
    triangles[edge->right] = {b, middle, d};
    triangles.push_back({middle, b, c});
    triangles.push_back({middle, a, d});
    return true;
}

PatchShape shape_of(const Patch& patch, std::span<const std::size_t> triangles, double shortest) {
    PatchShape shape{.least_goodness = 2.0};
    for (const std::size_t i : triangles) {
        if (!patch.has(i)) continue;
        const Triangle& t = patch.triangles[i];
        shape.least_goodness = std::min(shape.least_goodness, patch.goodness(t, shortest));
        shape.facing = std::min(shape.facing, facing_of(patch.points[t[0]], patch.points[t[1]], patch.points[t[2]]));
        for (std::size_t k = 0; k < 3; ++k) {
            const SurfacePoint& a = patch.points[t[k]];
            const SurfacePoint& b = patch.points[t[(k + 1) % 3]];
            shape.turn = std::min(shape.turn, dot(a.normal, b.normal));
            shape.longest = std::max(shape.longest, squared_norm(b.position - a.position));
            shape.shortest = std::min(shape.shortest, squared_norm(b.position - a.position));
        }
    }
    return shape;
}

std::vector<std::size_t> changed_triangles(const Patch& before, const Patch& after) {
    std::vector<std::size_t> changed;
    for_each_unequal(all_corners(before.triangles), all_corners(after.triangles),
                     [&](std::size_t corner) { changed.push_back(corner / 3); });
    for (std::size_t t = before.triangles.size(); t < after.triangles.size(); ++t) changed.push_back(t);
    for (std::size_t v = 0; v < after.points.size(); ++v) {
        if (v < before.points.size() && before.points[v].position == after.points[v].position) continue;
        after.for_each_corner(static_cast<VertexId>(v),
                              [&](std::size_t t, std::size_t /*corner*/) { changed.push_back(t); });
    }
    std::sort(changed.begin(), changed.end());
    changed.erase(std::unique(changed.begin(), changed.end()), changed.end());
    return changed;
}

std::optional<std::pair<std::size_t, std::size_t>> first_crossing(const Patch& patch, const std::vector<bool>& marked) {
    std::vector<Box> boxes;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) boxes.push_back(box_of(patch, t));
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const Triangle& s = patch.triangles[i];
        if (!patch.has(i) || !(marked[s[0]] || marked[s[1]] || marked[s[2]])) continue;
        const HeldTriangle held = held_triangle(patch, s);
        for (std::size_t j = 0; j < boxes.size(); ++j)
            if (i != j && boxes[i].overlaps(boxes[j]) && meets(held, patch, patch.triangles[j])) return std::pair(i, j);
    }
    return std::nullopt;
}

std::size_t count_crossings(const Patch& patch, std::span<const std::size_t> triangles) {
    struct Near {
        std::size_t triangle;
        Box box;
        bool counted;  // with all others
    };
    Box all;
    for (const std::size_t t : triangles) all.include(box_of(patch, t));
    std::vector<Near> near;
    for (std::size_t t = 0; t < patch.triangles.size(); ++t)
        if (const Box box = box_of(patch, t); box.overlaps(all)) near.push_back({t, box, false});
    std::size_t count = 0;
    for (const std::size_t t : triangles) {
        const auto found = std::lower_bound(
            near.begin(), near.end(), t, [](const Near& at, std::size_t triangle) { return at.triangle < triangle; });
        if (found == near.end() || found->triangle != t) continue;  // removed
        found->counted = true;
        const HeldTriangle held = held_triangle(patch, patch.triangles[t]);
        for (const Near& other : near)
            if (!other.counted && found->box.overlaps(other.box) && meets(held, patch, patch.triangles[other.triangle]))
                ++count;
    }
    return count;
}

}  // namespace meniscus
