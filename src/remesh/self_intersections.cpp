// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/self_intersections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>

#include "core/parallel_list.h"
#include "remesh/near_triangles.h"
#include "space/triangle_tree.h"

namespace meniscus {
namespace {

constexpr std::size_t kBoxesPerTask = 256;
constexpr std::size_t kNeighboursTogether = 16;  // neighbours that share what is near them

double orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    return dot(cross(b - a, c - a), d - a);
}

Vec3 normal_of(const std::array<Vec3, 3>& t) { return cross(t[1] - t[0], t[2] - t[0]); }

// On which side of a triangle's plane the corners of another are. normal: of the plane
std::array<double, 3> sides_of(const std::array<Vec3, 3>& s, const std::array<Vec3, 3>& t, const Vec3& normal) {
    return {dot(normal, s[0] - t[0]), dot(normal, s[1] - t[0]), dot(normal, s[2] - t[0])};
}

std::array<Vec3, 3> corners_of(const Mesh& mesh, const Triangle& t) {
    return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

// A corner of one triangle, and on which side of another one's plane it is.
struct SidedCorner {
    Vec3 at;
    double side;
};

// Where the inside of a segment passes through the inside of a triangle.
std::optional<Vec3> piercing(const SidedCorner& begin, const SidedCorner& end, const std::array<Vec3, 3>& t) {
    const auto& [p, from] = begin;
    const auto& [q, to] = end;
    if (from * to >= 0.0) return std::nullopt;
    const double u = orientation(p, q, t[0], t[1]);
    const double v = orientation(p, q, t[1], t[2]);
    const double w = orientation(p, q, t[2], t[0]);
    if (!((u > 0.0 && v > 0.0 && w > 0.0) || (u < 0.0 && v < 0.0 && w < 0.0))) return std::nullopt;
    return p + (from / (from - to)) * (q - p);
}

// All of them always: nobody could predict which.
bool contains(const Triangle& t, VertexId v) {
    const auto& [a, b, c] = t;
    return (a == v) | (b == v) | (c == v);
}

std::array<bool, 3> shared_corners(const Triangle& s, const Triangle& t) {
    return {contains(t, s[0]), contains(t, s[1]), contains(t, s[2])};
}

bool share_an_edge(const Triangle& s, const Triangle& t) {
    const auto [a, b, c] = shared_corners(s, t);
    return int{a} + int{b} + int{c} >= 2;
}

// One of two triangles that may meet. At most one corner is the other's, too.
struct Candidate {
    std::array<Vec3, 3> at;
    std::array<bool, 3> shared;
    std::array<double, 3> side;  // of the other's plane

    // Whether all of it but a shared corner is on one side of the other's plane.
    bool is_aside() const {
        const auto [shared_a, shared_b, shared_c] = shared;
        const auto [a, b, c] = side;
        const bool above = (shared_a | (a > 0.0)) & (shared_b | (b > 0.0)) & (shared_c | (c > 0.0));
        const bool below = (shared_a | (a < 0.0)) & (shared_b | (b < 0.0)) & (shared_c | (c < 0.0));
        return above | below;
    }
};

// Where a side of one triangle that has no corner of the other passes through the other.
std::optional<Vec3> sides_through(const Candidate& s, const std::array<Vec3, 3>& t) {
    for (std::size_t k = 0; k < 3; ++k) {
        const std::size_t next = (k + 1) % 3;
        if (s.shared[k] || s.shared[next]) continue;
        if (const auto place = piercing({s.at[k], s.side[k]}, {s.at[next], s.side[next]}, t)) return place;
    }
    return std::nullopt;
}

struct Crossing {
    Vec3 place;
    std::array<std::uint32_t, 2> triangles;
};

class Finder {
public:
    explicit Finder(const Mesh& mesh) : mesh_(mesh), triangles_(mesh) {
        boxes_.reserve(triangles_.order.size());
        for (const std::uint32_t t : triangles_.order) boxes_.push_back(box_of(mesh, mesh.triangles[t]));
    }

    std::vector<Crossing> run() const {
        const auto find = [&](std::size_t begin, std::size_t end, std::vector<Crossing>& found) {
            NearTriangles near;
            for (std::size_t i = begin; i < end; i += kNeighboursTogether)
                find_after(i, std::min(i + kNeighboursTogether, end), near, found);
        };
        return parallel_list<Crossing>(triangles_.order.size(), kBoxesPerTask, find);
    }

private:
    // Meetings of some triangles, which are neighbours, with all that follow them. `near` is memory.
    void find_after(std::size_t begin, std::size_t end, NearTriangles& near, std::vector<Crossing>& found) const {
        Box box;
        for (std::size_t i = begin; i < end; ++i) box.include(boxes_[i]);
        near.clear();
        triangles_.tree.for_each_overlapping(box, [&](std::uint32_t j) {
            if (j > begin) near.add(boxes_[j], j);
        });
        for (std::size_t i = begin; i < end; ++i) {
            const std::uint32_t number = triangles_.order[i];
            const HeldTriangle held(mesh_, mesh_.triangles[number]);
            near.for_each_overlapping(boxes_[i], [&](std::uint32_t j) {
                if (j <= i) return;
                const std::uint32_t other = triangles_.order[j];
                if (const auto place = held.meeting(mesh_, mesh_.triangles[other]))
                    found.push_back({*place, {number, other}});
            });
        }
    }

    const Mesh& mesh_;
    TriangleTree triangles_;
    std::vector<Box> boxes_;  // of the triangles in their order there
};

}  // namespace

HeldTriangle::HeldTriangle(const Triangle& corners, const std::array<Vec3, 3>& at)
    : corners_(corners), at_(at), normal_(normal_of(at)) {}

HeldTriangle::HeldTriangle(const Mesh& mesh, const Triangle& corners)
    : HeldTriangle(corners, corners_of(mesh, corners)) {}

std::optional<Vec3> HeldTriangle::meeting(const Triangle& other, const std::array<Vec3, 3>& at) const {
    return share_an_edge(corners_, other) ? std::nullopt : place_of_meeting(other, at);
}

std::optional<Vec3> HeldTriangle::meeting(const Mesh& mesh, const Triangle& other) const {
    return share_an_edge(corners_, other) ? std::nullopt : place_of_meeting(other, corners_of(mesh, other));
}

std::optional<Vec3> HeldTriangle::place_of_meeting(const Triangle& other, const std::array<Vec3, 3>& at) const {
    const Candidate second{at, shared_corners(other, corners_), sides_of(at, at_, normal_)};
    if (second.is_aside()) return std::nullopt;
    const Candidate first{at_, shared_corners(corners_, other), sides_of(at_, at, normal_of(at))};
    if (first.is_aside()) return std::nullopt;
    if (const auto place = sides_through(first, at)) return place;
    return sides_through(second, at_);
}

std::vector<Vec3> places_of_self_intersections(const Mesh& mesh) {
    std::vector<Vec3> places;
    for (const Crossing& crossing : Finder(mesh).run()) places.push_back(crossing.place);
    return places;
}

std::vector<std::uint32_t> self_intersecting_triangles(const Mesh& mesh) {
    std::vector<std::uint32_t> triangles;
    for (const Crossing& crossing : Finder(mesh).run())
        triangles.insert(triangles.end(), crossing.triangles.begin(), crossing.triangles.end());
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    return triangles;
}

}  // namespace meniscus
