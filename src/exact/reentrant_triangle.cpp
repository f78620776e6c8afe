// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/reentrant_triangle.h"

#include "simd/kernels.h"
#include "simd/pairs.h"

namespace meniscus {
namespace {

constexpr double kLargestBox = 8.0;  // Å, diagonal, of the positions of vertices that share a search

namespace short_vectors {
constexpr std::size_t kVectorBytes = 16;  // lists of probes nearby are short
#include "simd/vectors.inc"
}  // namespace short_vectors

// A box round the centres of all probes that come within a probe's radius of the triangle, its own among them.
// The triangle lies in the ball that has the rim of its cap as a great circle.
Box room_of_reaching(const ReentrantTriangle& triangle, const Vec3& position, double probe) {
    constexpr double kSlack = 1.001;  // what is_missed_by leaves to rounding, and the boxes of trees
    Box box;
    if (!triangle.within_cap) {
        box.include(position);
        return box.grown(kSlack * 2.0 * probe);
    }
    const double cosine = triangle.cos_farthest;
    box.include(position + probe * cosine * triangle.middle);
    return box.grown(kSlack * probe * (1.0 + std::sqrt(std::max(0.0, 1.0 - cosine * cosine))));
}

}  // namespace

ReentrantTriangle::ReentrantTriangle(const AccessibleSurface::Data& data, const SasVertex& vertex) {
    std::array<Vec3, kSides> to_atoms;
    for (std::size_t k = 0; k < kSides; ++k) {
        to_atoms[k] = data.atoms.centres[vertex.atoms[k]] - vertex.position;
        corners[k] = normalised(to_atoms[k]);
    }
    const auto& [a, b, c] = corners;
    // Away from the third corner: see SasVertex.
    const Pair3 ab_bc = cross(both(a, b), both(b, c));
    const Vec3 ca = cross(c, a);
    const Pair sines = norm(ab_bc);
    const double sine = norm(ca);
    const Pair3 away = (1.0 / sines) * ab_bc;
    sides = {away[0], away[1], (1.0 / sine) * ca};
    const Pair cosines = dot(both(a, b), both(b, c));
    const double cosine = dot(c, a);
    // The solid angle is van Oosterom & Strackee's (1983).
    const Pair first_two = arc_tangent(sines, cosines);
    const Pair last_and_half =
        arc_tangent(Pair{sine, std::abs(dot(a, ab_bc[1]))}, Pair{cosine, 1.0 + cosines[0] + cosines[1] + cosine});
    lengths = {first_two[0], first_two[1], last_and_half[0]};
    solid_angle = 2.0 * last_and_half[1];
    const Vec3 sum = a + b + c;
    middle = (1.0 / std::max(norm(sum), 1e-3)) * sum;
    cos_farthest = std::min({dot(middle, a), dot(middle, b), dot(middle, c)});
    within_cap = cos_farthest > 1e-3;
    out_of_reach = is_wide() && lies_between(to_atoms, data.probe);
}

// Whether the patch, of which `probe` is the radius, lies in the tetrahedron of the probe's centre v and its atoms'
// c_k. Then no other probe position y reaches it: |y - x|² - |v - x|² is linear in x, positive at v, and no less than 0
// at all c_k, since y lies in none of their enlarged balls and v on all of them.
bool ReentrantTriangle::lies_between(const std::array<Vec3, kSides>& to_atoms, double probe) const {
    constexpr double kSlack = 1.001;  // more than the perturbation and rounding by far
    const Vec3 normal = cross(to_atoms[1] - to_atoms[0], to_atoms[2] - to_atoms[0]);
    const double volume = dot(normal, to_atoms[0]);
    const double reach = kSlack * probe;
    if (volume * volume > reach * reach * squared_norm(normal)) return true;  // the plane is farther away
    const double length = std::copysign(norm(normal), volume);
    const Vec3 axis = (1.0 / length) * normal;
    const std::array<double, kSides> beyond{dot(axis, sides[0]), dot(axis, sides[1]), dot(axis, sides[2])};
    return volume / length > reach * cos_nearest(axis, beyond);
}

bool ReentrantTriangle::is_wide() const {
    constexpr double kSliver = 1e-6;  // steradian
    return within_cap && solid_angle > kSliver;
}

// Wholly beyond one side, as nearly all are that miss it, or off the nearest direction of the triangle.
bool ReentrantTriangle::is_missed_by(const Vec3& axis, double t) const {
    constexpr double kSlack = 1e-6;  // shifts of planes, rounding
    const double sine = std::sqrt(1.0 - t * t);
    const std::array<double, kSides> beyond{dot(axis, sides[0]), dot(axis, sides[1]), dot(axis, sides[2])};
    if (std::max({beyond[0], beyond[1], beyond[2]}) > sine + kSlack) return true;
    return within_cap && cos_nearest(axis, beyond) < t - kSlack;
}

// Cosine of the angle from a direction to the nearest one of the triangle: itself, or on a side that it lies beyond.
double ReentrantTriangle::cos_nearest(const Vec3& axis, const std::array<double, kSides>& beyond) const {
    double nearest = -1.0;
    bool inside = true;
    for (std::size_t k = 0; k < kSides; ++k) {
        if (beyond[k] <= 0.0) continue;
        inside = false;
        const Vec3& from = corners[k];
        const Vec3& to = corners[(k + 1) % kSides];
        const Vec3 across = cross(axis, sides[k]);
        const bool faces_side = dot(across, from) >= 0.0 && dot(across, to) <= 0.0;
        nearest = std::max(nearest, faces_side ? std::sqrt(std::max(0.0, 1.0 - beyond[k] * beyond[k]))
                                               : std::max(dot(axis, from), dot(axis, to)));
    }
    return inside ? 1.0 : nearest;
}

void NearProbes::visit(std::uint32_t v) {
    if (v < begin_ || v >= end_) search_around(v);
    visited_ = v;
    reaching_.clear();
    if (!triangle().out_of_reach) choose_reaching();
}

void NearProbes::search_around(std::uint32_t v) {
    Box positions;
    Box room;
    begin_ = end_ = v;
    while (end_ < data_.vertices.size() && end_ - begin_ < kGroup) {
        const SasVertex& vertex = data_.vertices[end_];
        positions.include(vertex.position);
        if (norm(positions.high - positions.low) > kLargestBox) break;
        ReentrantTriangle& triangle = triangles_[end_++ - begin_];
        triangle = ReentrantTriangle(data_, vertex);
        if (!triangle.out_of_reach) room.include(room_of_reaching(triangle, vertex.position, data_.probe));
    }
    list_near(room);
}

void NearProbes::list_near(const Box& room) {
    near_.clear();
    data_.vertex_tree.for_each_overlapping(room, [&](std::uint32_t v) { near_.push_back(v); });
    constexpr std::size_t kTogether = short_vectors::kSmallReals;
    const std::size_t padded = (near_.size() + kTogether - 1) / kTogether * kTogether;
    for (std::vector<float>* places : {&places_.x, &places_.y, &places_.z}) places->resize(padded);
    const Vec3& origin = data_.vertices[begin_].position;
    for (std::size_t i = 0; i < near_.size(); ++i) {
        const SmallVec3 place = to_small(data_.vertices[near_[i]].position - origin);
        places_.x[i] = place.x;
        places_.y[i] = place.y;
        places_.z[i] = place.z;
    }
}

// Leaves out what is_missed_by finds wholly beyond a side, and what is too far away: several at once, without a root,
// in single precision. A cap of t = d / 2R, at distance d, is beyond where (d b)² > d² (1 - t²), b = axis·side. Probes
// too large for single precision leave nothing out.
void NearProbes::choose_reaching() {
    const SmallVec3 at = to_small(data_.vertices[visited_].position - data_.vertices[begin_].position);
    const std::array<Vec3, ReentrantTriangle::kSides>& sides = triangle().sides;
    const std::array<SmallVec3, ReentrantTriangle::kSides> axes{to_small(sides[0]), to_small(sides[1]),
                                                                to_small(sides[2])};
    const double reach = 2.0 * data_.probe;
    const auto steepness = static_cast<float>(1.0 / (reach * reach));
    // Å²: more than ten times what rounding does to squares of coordinates that are at most as large as this sum.
    const auto slack = static_cast<float>(1e-5 * (reach + kLargestBox) * (reach + kLargestBox));
    using short_vectors::SmallReal;
    constexpr std::size_t kMarks = 64;
    for (std::size_t first = 0; first < near_.size(); first += kMarks) {
        const std::uint64_t marks = short_vectors::mark_if(std::min(kMarks, near_.size() - first), [&](std::size_t i) {
            const auto to_place = short_vectors::load3<SmallReal>(places_, first + i) - at;
            const SmallReal d2 = squared_norm(to_place);
            SmallReal beyond{};
            for (const SmallVec3& axis : axes) beyond = short_vectors::greater(dot(axis, to_place), beyond);
            const SmallReal room = d2 * (1.0F - d2 * steepness) + slack - beyond * beyond;
            return ~(room < 0.0F);
        });
        for_each_bit(marks, [&](std::size_t i) {
            if (near_[first + i] != visited_) reaching_.push_back(near_[first + i]);
        });
    }
}

}  // namespace meniscus
