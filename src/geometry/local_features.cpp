// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/local_features.h"

#include <algorithm>

#include "core/parallel.h"
#include "geometry/nearest_feature.h"

namespace meniscus {
namespace {

constexpr double kCellSlack = 1e-6;  // Å, for rounding at the borders of cells
constexpr std::size_t kPointsPerChunk = 2048;
constexpr std::size_t kPointsPerGather = 128;
constexpr double kLargestBox = 6.0;  // Å; larger groups of points are split

void gather_sphere_hits(const BoxTree& tree, const Box& box, double reach, std::vector<std::uint32_t>& items,
                        const auto& position) {
    items.clear();
    tree.for_each_overlapping(box.grown(reach), [&](std::uint32_t item) {
        if (box.squared_distance(position(item)) < reach * reach) items.push_back(item);
    });
}

void nearest_in_group(LocalFeatures& local, std::span<const Vec3> points, std::span<NearestFeature> result) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    if (points.size() > 1 && norm(box.high - box.low) > kLargestBox) {
        const std::size_t half = points.size() / 2;
        nearest_in_group(local, points.first(half), result.first(half));
        nearest_in_group(local, points.subspan(half), result.subspan(half));
        return;
    }
    local.gather(box);
    for (std::size_t i = 0; i < points.size(); ++i) result[i] = local.nearest(points[i]);
}

}  // namespace

// In K the nearest ball may not reach the box; it is within margin of the probe's contact all the same.
double LocalFeatures::beyond_balls() const { return std::max(0.0, margin_ - surface_->probe()); }

void LocalFeatures::gather(const Box& box) {
    const AccessibleSurface::Data& data = surface_->data();
    const double beyond = beyond_balls();
    balls_.clear();
    data.atom_tree.for_each_overlapping(box.grown(data.rho_max + beyond), [&](std::uint32_t i) {
        const double reach = data.rho[i] + beyond;
        if (box.squared_distance(data.atoms.centres[i]) < reach * reach) balls_.push_back(i);
    });
    arcs_.clear();
    data.arc_cell_tree.for_each_overlapping(box.grown(kCellSlack), [&](std::uint32_t a) { arcs_.push_back(a); });
    gather_sphere_hits(data.vertex_tree, box, data.probe + margin_, vertices_,
                       [&](std::uint32_t v) { return data.vertices[v].position; });
}

NearestFeature LocalFeatures::nearest(const Vec3& point) const {
    const AccessibleSurface::Data& data = surface_->data();
    NearestBall ball;
    for (const std::uint32_t i : balls_) {
        const double l = norm(point - data.atoms.centres[i]);
        ball.offer(i, data.rho[i] - l, l);
    }
    if (ball.depth <= -beyond_balls()) return surface_->nearest(point);  // a nearer one may not be listed
    if (owned_by_ball(data, ball, point)) return contact_feature(data, point, ball);
    NearestEdge edge;
    for (const std::uint32_t a : arcs_) edge.offer_arc(a, foot_on_arc(data.arcs[a], point));
    for (const std::uint32_t v : vertices_) edge.offer_vertex(v, squared_norm(point - data.vertices[v].position));
    const double reach = data.probe + margin_;
    if (edge.squared_distance >= reach * reach) return surface_->nearest(point);
    return edge_feature(data, point, edge);
}

std::vector<NearestFeature> nearest_features(const AccessibleSurface& surface, std::span<const Vec3> points) {
    constexpr double kMargin = 0.5;  // Å: points of a mesh are far nearer than this
    std::vector<NearestFeature> result(points.size());
    parallel_chunks(points.size(), kPointsPerChunk, [&](std::size_t begin, std::size_t end) {
        LocalFeatures local(surface, kMargin);
        for (std::size_t at = begin; at < end; at += kPointsPerGather) {
            const std::size_t count = std::min(kPointsPerGather, end - at);
            nearest_in_group(local, points.subspan(at, count), std::span(result).subspan(at, count));
        }
    });
    return result;
}

}  // namespace meniscus
