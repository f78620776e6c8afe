// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/nearest_batch.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

#include "geometry/parallel_curvature.h"

namespace meniscus {
namespace {

template <class T>
void set_point(LanePoints<T>& points, std::size_t lane, const Vec3& p) {
    points.x[lane] = static_cast<T>(p.x);
    points.y[lane] = static_cast<T>(p.y);
    points.z[lane] = static_cast<T>(p.z);
}

template <class T>
Vec3 get_point(const LanePoints<T>& points, std::size_t lane) {
    return {points.x[lane], points.y[lane], points.z[lane]};
}

template <class Visit>
void for_each_bit(std::uint64_t bits, const Visit& visit) {
    for (; bits != 0; bits &= bits - 1) visit(static_cast<std::size_t>(std::countr_zero(bits)));
}

}  // namespace

NearestBatch::Claim NearestBatch::start(const LocalFeatures& local, const Box& box, double margin) {
    local_ = &local;
    margin_ = margin;
    beyond_ = std::max(0.0, margin - data_->probe);
    box_ = box;
    middle_ = 0.5 * (box.low + box.high);
    half_diagonal_ = 0.5 * norm(box.high - box.low);
    if (local.balls().empty()) return Claim::Above;
    if (depths_in_middle_.size() < local.balls().padded_size()) depths_in_middle_.resize(local.balls().padded_size());
    kernels_.find_depths_of(middle_, local.balls(), depths_in_middle_.data());
    const auto end = depths_in_middle_.begin() + static_cast<std::ptrdiff_t>(local.balls().size());
    const double deepest = *std::max_element(depths_in_middle_.begin(), end);
    if (deepest + half_diagonal_ < -beyond_) return Claim::Above;
    if (deepest - half_diagonal_ > data_->probe + margin_) return Claim::Below;
    choose_contenders(deepest);
    return Claim::Open;
}

// Depths change by at most 1 per Å: whoever is more than a diagonal less deep in the middle is nowhere the deepest.
void NearestBatch::choose_contenders(double deepest) {
    const double enough = deepest - 2.0 * half_diagonal_ * (1.0 + 1e-9);
    const SphereList& balls = local_->balls();
    marks_.resize(std::max(marks_.size(), balls.size()));
    double extent = 0.0;
    for (std::size_t b = 0; b < balls.size(); ++b) {
        const double depth = depths_in_middle_[b];
        marks_[b] = depth >= enough ? 1 : 0;
        extent = std::max(extent, half_diagonal_ + 2.0 * balls.column(3)[b] - depth);
    }
    contenders_.select(balls, marks_);
    // With coordinates up to m from the middle and u = 2^-24, differences are off by 2 u m each, their norm by
    // (2 √3 + 3) u m, the depth by less than 8 u (m + rho).
    depth_error_ = 8.0 * 0x1p-24 * extent;
}

void NearestBatch::find(std::span<const Vec3> points) {
    points_ = points;
    load(points);
    kernels_.find_depths(small_, small_points_, points.size(), depths_);
    assign_to_balls();
    open_count_ = 0;
    claim_by_balls();
    if (open_count_ > 0) offer_edges();
    claim_by_edges();
}

void NearestBatch::load(std::span<const Vec3> points) {
    small_.clear();
    for (std::size_t b = 0; b < contenders_.size(); ++b) {
        const Vec3 from = position_in(contenders_, b) - middle_;
        small_.push_back({static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z),
                          static_cast<float>(contenders_.column(3)[b])});
    }
    for (std::size_t i = 0; i < points.size(); ++i) set_point(small_points_, i, points[i] - middle_);
}

// Settles what single precision can settle: which points are beyond the margin, and whose the others are.
void NearestBatch::assign_to_balls() {
    points_of_.assign(contenders_.size(), 0);
    const double above = -beyond_ - depth_error_;
    const double below = data_->probe + margin_ + depth_error_;
    for (std::size_t i = 0; i < points_.size(); ++i) {
        const float depth = depths_.first[i];
        claims_[i] = depth < above ? Claim::Above : depth > below ? Claim::Below : Claim::Open;
        if (claims_[i] != Claim::Open) continue;
        if (depth - depths_.second[i] > 2.0 * depth_error_)  // false for NaN, too
            points_of_[static_cast<std::size_t>(depths_.ball[i])] |= std::uint64_t{1} << i;
        else
            assign_exactly(i);
    }
}

void NearestBatch::assign_exactly(std::size_t point) {
    double best = -std::numeric_limits<double>::infinity();
    std::size_t deepest = 0;
    for (std::size_t b = 0; b < contenders_.size(); ++b) {
        const double depth = contenders_.column(3)[b] - norm(points_[point] - position_in(contenders_, b));
        if (depth > best) deepest = b;
        best = std::max(best, depth);
    }
    points_of_[deepest] |= std::uint64_t{1} << point;
}

void NearestBatch::claim_by_balls() {
    for (std::size_t b = 0; b < contenders_.size(); ++b)
        if (points_of_[b] != 0) claim_by_ball(b);
}

void NearestBatch::claim_by_ball(std::size_t contender) {
    const std::uint64_t points = points_of_[contender];
    std::size_t count = 0;
    for_each_bit(points, [&](std::size_t i) { set_point(lanes_, count++, points_[i]); });
    const std::uint32_t atom = contenders_.index(contender);
    const bool exposed = data_->exposed[atom] != 0;
    const auto caps = exposed ? data_->caps_of(atom) : std::span<const Cap>();
    kernels_.find_directions(position_in(contenders_, contender), caps, lanes_, count, directions_);
    std::size_t lane = 0;
    for_each_bit(points, [&](std::size_t i) {
        const double l = directions_.distance[lane];
        const double depth = contenders_.column(3)[contender] - l;
        const bool owned = depth <= 0.0 || (exposed && directions_.excess[lane] <= 0.0);
        ++lane;
        if (owned) {
            signed_distances_[i] = data_->probe - depth;
            claims_[i] = signed_distances_[i] < margin_ ? Claim::Ball : Claim::Above;
            atoms_[i] = atom;
        } else {
            open_[open_count_] = static_cast<std::uint8_t>(i);
            set_point(open_points_, open_count_++, points_[i]);
        }
    });
}

void NearestBatch::offer_edges() {
    choose_edges();
    std::fill_n(nearest_.squared_distance.at, open_count_, std::numeric_limits<double>::infinity());
    std::fill_n(nearest_.tag.at, open_count_, 0);
    kernels_.offer_vertices(local_->vertices(), vertices_, open_points_, open_count_, nearest_);
    drop_above();
    kernels_.offer_arcs(data_->arcs, arcs_, open_points_, open_count_, nearest_);
}

void NearestBatch::choose_edges() {
    marks_.resize(std::max({marks_.size(), local_->vertices().padded_size(), local_->arcs().padded_size()}));
    kernels_.mark_reaching(local_->vertices(), margin_, box_, marks_.data());
    vertices_.clear();
    for (std::uint32_t v = 0; v < local_->vertices().size(); ++v)
        if (marks_[v] != 0) vertices_.push_back(v);
    kernels_.mark_overlapping(local_->arcs(), box_, marks_.data());
    arcs_.clear();
    for (std::uint32_t a = 0; a < local_->arcs().size(); ++a)
        if (marks_[a] != 0) arcs_.push_back(local_->arcs().index(a));
}

// Every vertex is a point of K: where one is near enough, no arc can bring the point back within the margin.
void NearestBatch::drop_above() {
    const double near = data_->probe - margin_;
    if (near <= 0.0) return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open_count_; ++k) {
        if (nearest_.squared_distance[k] <= near * near) {
            claims_[open_[k]] = Claim::Above;
            continue;
        }
        open_[kept] = open_[k];
        set_point(open_points_, kept, get_point(open_points_, k));
        nearest_.squared_distance[kept] = nearest_.squared_distance[k];
        nearest_.tag[kept] = nearest_.tag[k];
        ++kept;
    }
    open_count_ = kept;
}

void NearestBatch::claim_by_edges() {
    for (std::size_t k = 0; k < open_count_; ++k) {
        const std::size_t i = open_[k];
        const double s = data_->probe - std::sqrt(nearest_.squared_distance[k]);
        claims_[i] = s >= margin_ ? Claim::Above : (s <= -margin_ ? Claim::Below : Claim::Edge);
        signed_distances_[i] = s;
        tags_[i] = nearest_.tag[k];
    }
}

double NearestBatch::mean_curvature(std::size_t point) const {
    const double distance = data_->probe - signed_distances_[point];
    if (claims_[point] == Claim::Ball) return contact_curvature(data_->rho[atoms_[point]] - distance);
    if (!is_arc(tags_[point])) return reentrant_curvature(distance);
    const SasArc& arc = data_->arcs[arc_of(tags_[point])];
    return toroidal_curvature(arc.radius, foot_on_arc(arc, points_[point]).from_axis, distance);
}

SurfaceStep NearestBatch::step_to_surface(std::size_t point) const {
    const Vec3& p = points_[point];
    if (claims_[point] == Claim::Ball) return step_from_ball(*data_, p, atoms_[point]);
    const std::int64_t tag = tags_[point];
    return is_arc(tag) ? step_from_arc(*data_, p, arc_of(tag))
                       : step_from_vertex(*data_, p, static_cast<std::uint32_t>(tag));
}

NearestFeature NearestBatch::feature(std::size_t point) const {
    const Vec3& p = points_[point];
    if (claims_[point] == Claim::Ball) {
        const std::uint32_t atom = atoms_[point];
        const double l = norm(p - data_->atoms.centres[atom]);
        return contact_feature(*data_, p, {atom, data_->rho[atom] - l, l});
    }
    NearestEdge edge;
    const std::int64_t tag = tags_[point];
    if (is_arc(tag)) {
        edge.arc = arc_of(tag);
        edge.squared_distance = foot_on_arc(data_->arcs[edge.arc], p).squared_distance;
    } else {
        edge.vertex = static_cast<std::uint32_t>(tag);
        edge.squared_distance = squared_norm(p - data_->vertices[edge.vertex].position);
    }
    return edge_feature(*data_, p, edge);
}

}  // namespace meniscus
