// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/distance_band.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "geometry/nearest_feature.h"
#include "geometry/parallel_curvature.h"

namespace meniscus {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::size_t kBlocksPerChunk = 16;

// Clamps to ±limit; a NaN (0/0 on the SAS itself) becomes the limit.
double clamped(double value, double limit) { return value > -limit ? (value < limit ? value : limit) : -limit; }

int node_x(int node) { return node % kBlockEdge; }
int node_y(int node) { return node / kBlockEdge % kBlockEdge; }
int node_z(int node) { return node / (kBlockEdge * kBlockEdge); }

}  // namespace

BlockDistance::BlockDistance(const AccessibleSurface& surface, double spacing, double margin)
    : surface_(&surface), data_(&surface.data()), local_(surface, margin), spacing_(spacing), margin_(margin) {}

Vec3 BlockDistance::position(int node) const {
    return corner_ + Vec3{spacing_ * node_x(node), spacing_ * node_y(node), spacing_ * node_z(node)};
}

BlockDistance::NodeRange BlockDistance::nodes_in(const Box& box) const {
    const auto first = [&](double offset) {
        return static_cast<int>(std::clamp(std::ceil(offset / spacing_), 0.0, double{kBlockEdge}));
    };
    const auto last = [&](double offset) {
        return static_cast<int>(std::clamp(std::floor(offset / spacing_) + 1.0, 0.0, double{kBlockEdge}));
    };
    const Vec3 low = box.low - corner_;
    const Vec3 high = box.high - corner_;
    return {{first(low.x), first(low.y), first(low.z)}, {last(high.x), last(high.y), last(high.z)}};
}

void BlockDistance::find_deepest_balls() {
    std::fill_n(depth_, kBlockNodes, -kInfinity);
    std::fill_n(ball_, kBlockNodes, 0);
    const auto balls = local_.balls();
    for (std::size_t b = 0; b < balls.size(); ++b) {
        const Vec3 from = corner_ - data_->atoms.centres[balls[b]];
        const double rho = data_->rho[balls[b]];
        for (int row = 0; row < kBlockEdge * kBlockEdge; ++row) {
            const int y = row % kBlockEdge;
            const int z = row / kBlockEdge;
            const double dy = from.y + spacing_ * y;
            const double dz = from.z + spacing_ * z;
            const double yz = dy * dy + dz * dz;
            double* depth = depth_ + node_in_block(0, y, z);
            std::int64_t* ball = ball_ + node_in_block(0, y, z);
            for (int x = 0; x < kBlockEdge; ++x) {
                const double dx = from.x + spacing_ * x;
                const double here = rho - std::sqrt(dx * dx + yz);
                ball[x] = here > depth[x] ? static_cast<std::int64_t>(b) : ball[x];
                depth[x] = here > depth[x] ? here : depth[x];
            }
        }
    }
}

void BlockDistance::claim_by_balls() {
    open_ = 0;
    for (int node = 0; node < kBlockNodes; ++node) {
        squared_arc_[node] = kInfinity;
        if (depth_[node] > data_->probe + margin_) {
            claim_[node] = Claim::Deep;
            continue;
        }
        const bool beyond_all = std::isinf(depth_[node]);  // no ball near: in K, farther than margin
        const NearestBall ball{
            beyond_all ? 0 : local_.balls()[static_cast<std::size_t>(ball_[node])], depth_[node],
            beyond_all ? 0.0 : data_->rho[local_.balls()[static_cast<std::size_t>(ball_[node])]] - depth_[node]};
        const bool owned = beyond_all || owned_by_ball(*data_, ball, position(node));
        claim_[node] = owned ? Claim::Ball : Claim::Open;
        open_ += owned ? 0 : 1;
    }
}

void BlockDistance::offer_arcs() {
    constexpr double kSlack = 1e-6;  // Å, for rounding at the borders of cells
    for (const std::uint32_t a : local_.arcs()) {
        const SasArc& arc = data_->arcs[a];
        const NodeRange range = nodes_in(data_->arc_cells[a].grown(kSlack));
        for (int z = range.begin[2]; z < range.end[2]; ++z)
            for (int y = range.begin[1]; y < range.end[1]; ++y)
                for (int x = range.begin[0]; x < range.end[0]; ++x) {
                    const int node = node_in_block(x, y, z);
                    if (claim_[node] != Claim::Open) continue;
                    const ArcFoot foot = foot_on_arc(arc, position(node));
                    if (!foot.within || foot.squared_distance >= squared_arc_[node]) continue;
                    squared_arc_[node] = foot.squared_distance;
                    arc_[node] = a;
                    if (in_arc_cell(arc, foot)) {
                        claim_[node] = Claim::Arc;
                        --open_;
                    }
                }
    }
}

void BlockDistance::offer_vertices() {
    const double reach = data_->probe + margin_;
    for (const std::uint32_t v : local_.vertices()) {
        const Vec3 from = corner_ - data_->vertices[v].position;
        Box box;
        box.include(data_->vertices[v].position);
        const NodeRange range = nodes_in(box.grown(reach));
        for (int z = range.begin[2]; z < range.end[2]; ++z)
            for (int y = range.begin[1]; y < range.end[1]; ++y) {
                const double dy = from.y + spacing_ * y;
                const double dz = from.z + spacing_ * z;
                const double yz = dy * dy + dz * dz;
                double* nearest = squared_vertex_ + node_in_block(0, y, z);
                for (int x = 0; x < kBlockEdge; ++x) {  // whole rows, claimed or not: it vectorises
                    const double dx = from.x + spacing_ * x;
                    nearest[x] = std::min(nearest[x], dx * dx + yz);
                }
            }
    }
}

BlockDistance::Sample BlockDistance::sample(int node) const {
    if (claim_[node] == Claim::Deep) return {-kInfinity, 0.0};
    if (claim_[node] == Claim::Ball) {
        if (std::isinf(depth_[node])) return {kInfinity, 0.0};
        const double l = data_->rho[local_.balls()[static_cast<std::size_t>(ball_[node])]] - depth_[node];
        return {data_->probe - depth_[node], contact_curvature(l)};
    }
    if (claim_[node] == Claim::Open && squared_vertex_[node] <= squared_arc_[node]) {
        const double distance = std::sqrt(squared_vertex_[node]);  // infinite: no feature within probe + margin
        return {data_->probe - distance, reentrant_curvature(distance)};
    }
    const double distance = std::sqrt(squared_arc_[node]);
    const SasArc& arc = data_->arcs[arc_[node]];
    const double from_axis = foot_on_arc(arc, position(node)).from_axis;
    return {data_->probe - distance, toroidal_curvature(arc.radius, from_axis, distance)};
}

void BlockDistance::evaluate(const Vec3& corner, std::span<float, kBlockNodes> distance,
                             std::span<float, kBlockNodes> curvature) {
    corner_ = corner;
    Box box;
    box.include(corner);
    box.include(position(kBlockNodes - 1));
    local_.gather(box);
    find_deepest_balls();
    claim_by_balls();
    if (open_ > 0) offer_arcs();
    std::fill_n(squared_vertex_, kBlockNodes, kInfinity);
    if (open_ > 0) offer_vertices();
    for (int node = 0; node < kBlockNodes; ++node) {
        const auto [s, h] = sample(node);
        const auto at = static_cast<std::size_t>(node);
        distance[at] = static_cast<float>(clamped(s, margin_));
        curvature[at] = std::abs(s) < margin_ ? static_cast<float>(clamped(h, 1.0 / spacing_)) : 0.0F;
    }
}

DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin) {
    DistanceBand band;
    band.margin = margin;
    band.distance.resize(grid.node_count());
    band.curvature.resize(grid.node_count());
    parallel_chunks(grid.block_count(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        const auto evaluator = std::make_unique<BlockDistance>(surface, grid.spacing(), margin);
        for (std::size_t b = begin; b < end; ++b)
            evaluator->evaluate(grid.corner(static_cast<BlockId>(b)),
                                std::span<float, kBlockNodes>(band.distance.data() + b * kBlockNodes, kBlockNodes),
                                std::span<float, kBlockNodes>(band.curvature.data() + b * kBlockNodes, kBlockNodes));
    });
    return band;
}

}  // namespace meniscus
