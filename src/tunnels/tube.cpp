// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include "core/perpendicular.h"
#include "core/requirements.h"
#include "meniscus/errors.h"
#include "meniscus/tunnels.h"

namespace meniscus {
namespace {

constexpr double kBlur = 0.5;  // Å: standard deviation of the average along the way
constexpr int kLeastCorners = 12;

struct Disc {
    Vec3 centre;
    double radius = 0.0;
};

// The average of a path at a distance along it. Its window is cut on both sides alike, so that the ends stay.
Disc average(const TunnelPath& path, double distance) {
    const double reach = std::min({3.0 * kBlur, distance, path.length - distance});
    Disc sum;
    double weights = 0.0;
    const auto first = std::lower_bound(path.points.begin(), path.points.end(), distance - reach,
                                        [](const PathPoint& p, double at) { return p.distance < at; });
    const auto add = [&](const Vec3& position, double radius, double offset) {
        const double weight = std::exp(-0.5 * offset * offset / (kBlur * kBlur));
        sum.centre += weight * position;
        sum.radius += weight * radius;
        weights += weight;
    };
    for (auto p = first; p != path.points.end() && p->distance <= distance + reach; ++p)
        add(p->position, p->radius, p->distance - distance);
    // The place itself, between two points.
    const auto next = std::lower_bound(path.points.begin() + 1, path.points.end() - 1, distance,
                                       [](const PathPoint& p, double at) { return p.distance < at; });
    const PathPoint& a = *(next - 1);
    const double span = next->distance - a.distance;
    const double t = span > 0.0 ? std::clamp((distance - a.distance) / span, 0.0, 1.0) : 0.0;
    add(a.position + t * (next->position - a.position), a.radius + t * (next->radius - a.radius), 0.0);
    return {(1.0 / weights) * sum.centre, sum.radius / weights};
}

std::vector<Disc> discs_of(const TunnelPath& path, double edge) {
    if (path.points.size() < 2 || !(path.length > 0.0)) {
        const PathPoint& p = path.points.front();
        return {{p.position, p.radius}};
    }
    const auto parts = static_cast<std::size_t>(std::ceil(path.length / edge));
    std::vector<Disc> discs;
    for (std::size_t i = 0; i <= parts; ++i)
        discs.push_back(average(path, path.length * static_cast<double>(i) / static_cast<double>(parts)));
    return discs;
}

// Ring by ring from the pole of the first half ball to that of the last.
class TubeMesh {
public:
    explicit TubeMesh(std::size_t corners) : corners_(corners) {}

    // A ring round a point of the axis; `lean` is the part of its normals along the axis.
    void add_ring(const Disc& disc, const Vec3& axis, double lean) {
        turn_to(axis);
        const Vec3 other = cross(axis, side_);
        const double across = std::sqrt(std::max(0.0, 1.0 - lean * lean));
        for (std::size_t i = 0; i < corners_; ++i) {
            const double angle = 2.0 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(corners_);
            const Vec3 out = std::cos(angle) * side_ + std::sin(angle) * other;
            add_vertex(disc.centre + disc.radius * out, across * out + lean * axis);
        }
        if (mesh_.vertices.size() >= 2 * corners_ + 1) join_rings();
    }

    void add_pole(const Vec3& place, const Vec3& normal) {
        add_vertex(place, normal);
        const VertexId pole = last();
        if (pole == 0) return;
        for (std::size_t i = 0; i < corners_; ++i)
            mesh_.triangles.push_back({pole, corner(pole, i), corner(pole, i + 1)});
    }

    // The first ring with the pole before it.
    void close_begin() {
        for (std::size_t i = 0; i < corners_; ++i)
            mesh_.triangles.push_back({0, corner(1 + corners_, i + 1), corner(1 + corners_, i)});
    }

    Mesh take() { return std::move(mesh_); }

private:
    VertexId last() const { return static_cast<VertexId>(mesh_.vertices.size() - 1); }
    // Corner i of the ring that ends before a vertex.
    VertexId corner(std::size_t end, std::size_t i) const {
        return static_cast<VertexId>(end - corners_ + i % corners_);
    }

    void add_vertex(const Vec3& place, const Vec3& normal) {
        mesh_.vertices.push_back(place);
        mesh_.normals.push_back(
            {static_cast<float>(normal.x), static_cast<float>(normal.y), static_cast<float>(normal.z)});
    }

    void join_rings() {
        const std::size_t end = mesh_.vertices.size();
        for (std::size_t i = 0; i < corners_; ++i) {
            const VertexId a = corner(end - corners_, i);
            const VertexId b = corner(end - corners_, i + 1);
            const VertexId c = corner(end, i);
            const VertexId d = corner(end, i + 1);
            mesh_.triangles.push_back({a, b, d});
            mesh_.triangles.push_back({a, d, c});
        }
    }

    // Carries the direction of the first corner along without twisting it.
    void turn_to(const Vec3& axis) {
        const Vec3 across = side_ - dot(side_, axis) * axis;
        side_ = norm(across) > 1e-6 ? normalised(across) : perpendicular(axis);
    }

    Mesh mesh_;
    std::size_t corners_;
    Vec3 side_;
};

void check(const TunnelPath& path, double edge) {
    require_positive("edge", edge);
    if (path.points.empty()) throw UsageError("a path without points has no tube");
    if (std::any_of(path.points.begin(), path.points.end(), [](const PathPoint& p) { return !(p.radius > 0.0); }))
        throw UsageError("a path with radii that are not positive has no tube");
}

}  // namespace

Mesh tube_of(const TunnelPath& path, double edge) {
    check(path, edge);
    const std::vector<Disc> discs = discs_of(path, edge);
    const std::size_t n = discs.size();
    double widest = 0.0;
    for (const Disc& disc : discs) widest = std::max(widest, disc.radius);
    const int corners = std::max(kLeastCorners, static_cast<int>(std::ceil(2.0 * std::numbers::pi * widest / edge)));
    const int steps = (corners + 3) / 4;  // of a quarter of a circle
    const auto axis_at = [&](std::size_t i) {
        const Vec3 along = discs[std::min(i + 1, n - 1)].centre - discs[i > 0 ? i - 1 : 0].centre;
        return norm(along) > 0.0 ? normalised(along) : Vec3{0.0, 0.0, 1.0};
    };
    TubeMesh tube(static_cast<std::size_t>(corners));
    const auto add_cap_ring = [&](const Disc& disc, const Vec3& axis, double lean) {
        tube.add_ring({disc.centre + disc.radius * lean * axis, disc.radius * std::sqrt(1.0 - lean * lean)}, axis,
                      lean);
    };
    const auto lean_of = [&](int step) { return std::cos(0.5 * std::numbers::pi * step / steps); };

    tube.add_pole(discs[0].centre - discs[0].radius * axis_at(0), -axis_at(0));
    for (int k = 1; k < steps; ++k) {
        add_cap_ring(discs[0], axis_at(0), -lean_of(k));
        if (k == 1) tube.close_begin();
    }
    for (std::size_t i = 0; i < n; ++i) {
        const Disc& before = discs[i > 0 ? i - 1 : 0];
        const Disc& after = discs[std::min(i + 1, n - 1)];
        const double length = norm(after.centre - before.centre);
        const double slope = length > 0.0 ? (after.radius - before.radius) / length : 0.0;
        tube.add_ring(discs[i], axis_at(i), -slope / std::sqrt(1.0 + slope * slope));
    }
    for (int k = steps - 1; k > 0; --k) add_cap_ring(discs[n - 1], axis_at(n - 1), lean_of(k));
    tube.add_pole(discs[n - 1].centre + discs[n - 1].radius * axis_at(n - 1), axis_at(n - 1));
    return tube.take();
}

}  // namespace meniscus
