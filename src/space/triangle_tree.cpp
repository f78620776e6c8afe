// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "space/triangle_tree.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/elementary.h"
#include "space/canonical_atoms.h"

namespace meniscus {
namespace {

// By their first corners.
std::vector<std::uint32_t> triangles_in_spatial_order(const Mesh& mesh) {
    constexpr double kCells = (1 << 21) - 1;  // along the longest edge of the box round the mesh
    const Box all = box_of(mesh.vertices);
    const Vec3 extent = all.high - all.low;
    const double scale = kCells / std::max({extent.x, extent.y, extent.z, 1e-9});
    const auto cell = [scale](double offset) { return static_cast<std::uint32_t>(scale * offset); };
    std::vector<std::pair<std::uint64_t, std::uint32_t>> keys;
    keys.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles) {
        const Vec3 from = mesh.vertices[t[0]] - all.low;
        const auto number = static_cast<std::uint32_t>(keys.size());
        keys.emplace_back(morton_key(cell(from.x), cell(from.y), cell(from.z)), number);
    }
    std::sort(keys.begin(), keys.end());
    std::vector<std::uint32_t> order;
    order.reserve(keys.size());
    for (const auto& [key, triangle] : keys) order.push_back(triangle);
    return order;
}

std::vector<Box> boxes_of(const Mesh& mesh, const std::vector<std::uint32_t>& order) {
    std::vector<Box> boxes;
    boxes.reserve(order.size());
    for (const std::uint32_t t : order) boxes.push_back(box_of(mesh, mesh.triangles[t]));
    return boxes;
}

double angle_at(const Vec3& p, const Vec3& q, const Vec3& r) {
    const Vec3 a = q - p;
    const Vec3 b = r - p;
    return elementary::atan2(norm(cross(a, b)), dot(a, b));
}

// Where in a triangle the point nearest to another is: at a corner, on an edge, within.
enum class Part { A, B, C, Edge, Inside };

// Ericson 2005, Real-Time Collision Detection, 5.1.5.
std::pair<Vec3, Part> nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = dot(ab, p - a);
    const double d2 = dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return {a, Part::A};
    const double d3 = dot(ab, p - b);
    const double d4 = dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return {b, Part::B};
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + (d1 / (d1 - d3)) * ab, Part::Edge};
    const double d5 = dot(ab, p - c);
    const double d6 = dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return {c, Part::C};
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + (d2 / (d2 - d6)) * ac, Part::Edge};
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return {b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b), Part::Edge};
    const double scale = 1.0 / (va + vb + vc);
    return {a + (vb * scale) * ab + (vc * scale) * ac, Part::Inside};
}

double squared_distance(const Mesh& mesh, const Triangle& triangle, const Vec3& point) {
    const auto& [a, b, c] = triangle;
    return squared_norm(point - nearest_in_triangle(point, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]).first);
}

// No distance is longer than that to a triangle, which is not a number where that has no area.
double bound_by(const Mesh& mesh, const Triangle& triangle, const Vec3& point) {
    const double distance2 = squared_distance(mesh, triangle, point);
    return std::isnan(distance2) ? std::numeric_limits<double>::infinity() : distance2;
}

double angle_of(Part part, const Vec3& a, const Vec3& b, const Vec3& c) {
    switch (part) {
        case Part::A:
            return angle_at(a, b, c);
        case Part::B:
            return angle_at(b, c, a);
        case Part::C:
            return angle_at(c, a, b);
        case Part::Edge:
            return std::numbers::pi;
        default:
            return 2.0 * std::numbers::pi;
    }
}

// A triangle that may have the nearest point.
struct Candidate {
    std::uint32_t triangle = 0;
    Vec3 point;
    Part part = Part::Inside;
    double distance2 = 0.0;
};

// Distances that are equal but for rounding, and points that are.
constexpr double kRelative = 1e-9;
constexpr double kAbsolute = 1e-11;  // Å

double tied(double distance2) {
    const double distance = std::sqrt(distance2) * (1.0 + kRelative) + kAbsolute;
    return distance * distance;
}

// The normals of the candidates that meet at the best one's point, weighted by their angles. Others are as near where
// the point has several nearest ones; each tells the side by itself.
Vec3 normal_at(const Mesh& mesh, const std::vector<Candidate>& candidates, const Candidate& best) {
    const double reach = kRelative * std::sqrt(best.distance2) + kAbsolute;
    Vec3 sum;
    for (const Candidate& candidate : candidates) {
        if (squared_norm(candidate.point - best.point) > reach * reach) continue;
        const auto& [i, j, k] = mesh.triangles[candidate.triangle];
        const Vec3& a = mesh.vertices[i];
        const Vec3& b = mesh.vertices[j];
        const Vec3& c = mesh.vertices[k];
        const Vec3 normal = cross(b - a, c - a);
        const double length = norm(normal);
        if (length > 0.0) sum += (angle_of(candidate.part, a, b, c) / length) * normal;
    }
    return sum;
}

}  // namespace

TriangleTree::TriangleTree(const Mesh& mesh) : order(triangles_in_spatial_order(mesh)), tree(boxes_of(mesh, order)) {}

double TriangleTree::distance(const Mesh& mesh, const Vec3& point) const {
    double least = std::numeric_limits<double>::infinity();
    tree.search_nearest(
        point, [&least] { return least; },
        [&](std::uint32_t i) { least = std::min(least, squared_distance(mesh, mesh.triangles[order[i]], point)); });
    return std::sqrt(least);
}

double TriangleTree::distance(const Mesh& mesh, const Vec3& point, std::uint32_t near) const {
    double least = bound_by(mesh, mesh.triangles[near], point);
    const Box reached = Box{point, point}.grown(std::sqrt(tied(least)));
    tree.for_each_overlapping(reached, [&](std::uint32_t i) {
        least = std::min(least, squared_distance(mesh, mesh.triangles[order[i]], point));
    });
    return std::sqrt(least);
}

NearestOnMesh TriangleTree::nearest(const Mesh& mesh, const Vec3& point, std::uint32_t near) const {
    std::vector<Candidate> candidates;
    Candidate best;
    best.distance2 = std::numeric_limits<double>::infinity();
    double most = tied(bound_by(mesh, mesh.triangles[near], point));
    tree.search_nearest(
        point, [&most] { return most; },
        [&](std::uint32_t i) {
            const auto& [a, b, c] = mesh.triangles[order[i]];
            const auto [nearest, part] =
                nearest_in_triangle(point, mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]);
            const Candidate found{order[i], nearest, part, squared_norm(point - nearest)};
            if (found.distance2 > most) return;
            if (found.distance2 < best.distance2) {
                best = found;
                most = tied(found.distance2);
            }
            candidates.push_back(found);
        });
    const double side = dot(point - best.point, normal_at(mesh, candidates, best));
    return {best.point, std::copysign(std::sqrt(best.distance2), side), best.triangle};
}

}  // namespace meniscus
