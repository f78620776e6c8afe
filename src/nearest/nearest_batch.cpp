// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/nearest_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace meniscus {
namespace {

constexpr std::size_t kChains = 2;

}  // namespace

NearestBatch::Claim NearestBatch::start(const LocalFeatures& local, const Box& box, double margin) {
    local_ = &local;
    margin_ = margin;
    beyond_ = std::max(0.0, margin - data_->probe);
    box_ = box;
    middle_ = box.middle();
    half_diagonal_ = 0.5 * norm(box.high - box.low);
    if (local.balls().empty()) return Claim::Above;
    if (depths_in_middle_.size() < local.balls().padded_size()) depths_in_middle_.resize(local.balls().padded_size());
    const std::size_t deepest = kernels_.find_depths_of(middle_, local.balls(), depths_in_middle_.data());
    const double depth = depths_in_middle_[deepest];
    if (depth + half_diagonal_ < -beyond_) return Claim::Above;
    if (depth - half_diagonal_ > data_->probe + margin_) return Claim::Below;
    choose_contenders(deepest);
    return Claim::Open;
}

// Balls that may be deeper somewhere than the one that is deepest in the middle.
void NearestBatch::choose_contenders(std::size_t deepest) {
    const SphereList& balls = local_->balls();
    marks_.resize(std::max(marks_.size(), words_for(balls.size())));
    kernels_.mark_contenders(balls, deepest, box_, marks_.data());
    contenders_.select(balls, marks_.data());
    // In the middle they are less deep by two diagonals at most.
    const double extent = 5.0 * half_diagonal_ + 2.0 * data_->rho_max - depths_in_middle_[deepest];
    // With coordinates up to m from the middle and u = 2^-24, differences are off by 2 u m each, their norm by
    // (2 √3 + 3) u m, the depth by less than 8 u (m + rho).
    depth_error_ = 8.0 * 0x1p-24 * extent;
}

void NearestBatch::find(std::span<const Vec3> points) {
    for (std::size_t i = 0; i < points.size(); ++i) set_point(given_, i, points[i]);
    find(given_, points.size());
}

void NearestBatch::find(const LanePoints<double>& points, std::size_t count) {
    points_ = &points;
    count_ = count;
    load();
    kernels_.find_depths(small_, small_points_, count, depths_);
    group_points();
    sort_by_groups();
    claim_by_groups();
    collect_open();
    if (open_count_ > 0) offer_edges();
    claim_by_edges();
}

void NearestBatch::load() {
    small_.resize(contenders_.size());
    for (std::size_t b = 0; b < contenders_.size(); ++b) {
        const Vec3 from = position_in(contenders_, b) - middle_;
        small_[b] = {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z),
                     static_cast<float>(contenders_.column(3)[b])};
    }
    kernels_.make_small(*points_, middle_, count_, small_points_);
}

// Settles what single precision can settle: which points are beyond the margin, and whose the others may be.
void NearestBatch::group_points() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const auto above = static_cast<float>(-beyond_ - depth_error_);
    const auto below = static_cast<float>(data_->probe + margin_ + depth_error_);
    const auto lead = static_cast<float>(2.0 * depth_error_);
    const DepthLimits limits{.above = std::nextafter(above, -kInfinity),
                             .below = std::nextafter(below, kInfinity),
                             .lead = std::nextafter(lead, kInfinity),
                             .balls = static_cast<std::int32_t>(contenders_.size())};
    kernels_.group_points(depths_, limits, count_, groups_);
}

std::size_t NearestBatch::deepest_exactly(const Vec3& point) const {
    double best = -std::numeric_limits<double>::infinity();
    std::size_t deepest = 0;
    for (std::size_t b = 0; b < contenders_.size(); ++b) {
        const double depth = contenders_.column(3)[b] - norm(point - position_in(contenders_, b));
        if (depth > best) deepest = b;
        best = std::max(best, depth);
    }
    return deepest;
}

// A counting sort. Points next to each other mostly have the same group: they count in several chains, or each would
// have to wait for the one before.
void NearestBatch::sort_by_groups() {
    ends_.assign(kChains * (contenders_.size() + kSpecialGroups), 0);
    const auto end_of = [&](std::size_t i) -> std::uint32_t& {
        return ends_[kChains * static_cast<std::size_t>(groups_[i]) + i % kChains];
    };
    const LanePoints<double>& points = *points_;
    const std::size_t count = count_;
    for (std::size_t i = 0; i < count; ++i) ++end_of(i);
    std::exclusive_scan(ends_.begin(), ends_.end(), ends_.begin(), std::uint32_t{0});
    for (std::size_t i = 0; i < count; ++i) {
        const std::uint32_t lane = end_of(i)++;
        sorted_[lane] = static_cast<std::uint32_t>(i);
        lane_of_[i] = lane;
        set_point(lanes_, lane, get_point(points, i));
    }
}

LaneRange NearestBatch::lanes_of(std::size_t group) const {
    return {group == 0 ? 0 : ends_[kChains * group - 1], ends_[kChains * (group + 1) - 1]};
}

// In the order of the lanes: kernels write beyond the end of a range.
void NearestBatch::claim_by_groups() {
    const std::size_t balls = contenders_.size();
    for (std::size_t b = 0; b < balls; ++b)
        if (const LaneRange lanes = lanes_of(b); lanes.end > lanes.begin) claim_by_ball(b, lanes);
    const LaneRange doubtful = lanes_of(balls + kDoubtfulGroup);
    for (std::size_t lane = doubtful.begin; lane < doubtful.end; ++lane)
        claim_by_ball(deepest_exactly(get_point(lanes_, lane)), {lane, lane + 1});
    claim_by_side(margin_, lanes_of(balls + kAboveGroup));
    claim_by_side(-margin_, lanes_of(balls + kBelowGroup));
}

void NearestBatch::claim_by_side(double signed_distance, const LaneRange& lanes) {
    std::fill(claims_.signed_distance.at + lanes.begin, claims_.signed_distance.at + lanes.end, signed_distance);
    std::fill(claims_.owned.at + lanes.begin, claims_.owned.at + lanes.end, 0);
}

void NearestBatch::claim_by_ball(std::size_t contender, const LaneRange& lanes) {
    const std::uint32_t atom = contenders_.index(contender);
    BallOwner ball{
        position_in(contenders_, contender), contenders_.column(3)[contender], data_->exposed[atom] != 0, {}};
    if (ball.exposed) ball.caps = data_->caps_of(atom);
    kernels_.claim(ball, data_->probe, lanes_, lanes, claims_);
    std::fill(atoms_.at + lanes.begin, atoms_.at + lanes.end, atom);
}

// Without a branch, for nobody could predict it.
void NearestBatch::collect_open() {
    const std::size_t end = lanes_of(contenders_.size() + kDoubtfulGroup).end;
    open_count_ = 0;
    for (std::size_t lane = 0; lane < end; ++lane) {
        open_[open_count_] = static_cast<std::uint32_t>(lane);
        open_count_ += claims_.owned[lane] != 0 ? 0 : 1;
    }
    for (std::size_t k = 0; k < open_count_; ++k) set_point(open_points_, k, get_point(lanes_, open_[k]));
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
    const SphereList& vertices = local_->vertices();
    const BoxList& arcs = local_->arcs();
    marks_.resize(std::max({marks_.size(), words_for(vertices.size()), words_for(arcs.size())}));
    kernels_.mark_reaching(vertices, margin_, box_, marks_.data());
    kernels_.unmark_far(vertices, box_, marks_.data());
    vertices_.resize(vertices.size());
    vertices_.resize(list_items(marks_.data(), vertices.size(), vertices_.data()));
    kernels_.mark_overlapping(arcs, box_, marks_.data());
    arcs_.resize(arcs.size());
    arcs_.resize(list_items(marks_.data(), arcs.size(), arcs_.data()));
    for (std::uint32_t& a : arcs_) a = arcs.index(a);
}

// Every vertex is a point of K: where one is near enough, no arc can bring the point back within the margin.
void NearestBatch::drop_above() {
    const double near = data_->probe - margin_;
    const auto is_above = [near](double squared_distance) { return squared_distance <= near * near; };
    if (near <= 0.0 || std::none_of(nearest_.squared_distance.at, nearest_.squared_distance.at + open_count_, is_above))
        return;
    std::size_t kept = 0;
    for (std::size_t k = 0; k < open_count_; ++k) {
        const bool above = is_above(nearest_.squared_distance[k]);
        claims_.signed_distance[open_[k]] = margin_;  // the last word only if it is above
        open_[kept] = open_[k];
        set_point(open_points_, kept, get_point(open_points_, k));
        nearest_.squared_distance[kept] = nearest_.squared_distance[k];
        nearest_.tag[kept] = nearest_.tag[k];
        kept += above ? 0 : 1;
    }
    open_count_ = kept;
}

void NearestBatch::claim_by_edges() {
    kernels_.find_edge_distances(nearest_, data_->probe, open_count_, edge_distances_);
    for (std::size_t k = 0; k < open_count_; ++k) {
        claims_.signed_distance[open_[k]] = edge_distances_[k];
        tags_[open_[k]] = nearest_.tag[k];
    }
}

// Each formula for all lanes, without asking whose they are: nobody could predict it.
void NearestBatch::find_curvatures() {
    kernels_.find_ball_curvatures(claims_, data_->probe, count_, curvatures_);
    kernels_.find_edge_curvatures(nearest_, data_->probe, open_count_, edge_curvatures_);
    for (std::size_t k = 0; k < open_count_; ++k) curvatures_[open_[k]] = edge_curvatures_[k];
}

void NearestBatch::write(std::span<const std::uint32_t> places, double limit, float* distances, float* curvatures) {
    kernels_.clamp(claims_.signed_distance, margin_, count_, clamped_);
    kernels_.clamp(curvatures_, limit, count_, clamped_curvatures_);
    kernels_.clear_beyond(claims_.signed_distance, margin_, count_, clamped_curvatures_);
    for (std::size_t lane = 0; lane < count_; ++lane) {
        const std::uint32_t place = places[sorted_[lane]];
        distances[place] = clamped_[lane];
        curvatures[place] = clamped_curvatures_[lane];
    }
}

Vec3 NearestBatch::foot(std::size_t point) const {
    const Vec3 p = get_point(*points_, point);
    const auto [kind, index] = cell_of(lane_of_[point]);
    switch (kind) {
        case FeatureCell::Kind::Ball: {
            const Vec3& centre = data_->atoms.centres[index];
            return centre + (data_->rho[index] / norm(p - centre)) * (p - centre);
        }
        case FeatureCell::Kind::Arc: {
            const SasArc& arc = data_->arcs[index];
            const ArcFoot on_arc = foot_on_arc(arc, p);
            return arc.centre + (arc.radius / on_arc.from_axis) * on_arc.radial;
        }
        default:
            return data_->vertices[index].position;
    }
}

SurfaceStep NearestBatch::step_to_surface(std::size_t point) const {
    return step_from(*data_, get_point(*points_, point), cell_of(lane_of_[point]));
}

FeatureCell NearestBatch::cell_of(std::size_t lane) const {
    if (claims_.owned[lane] != 0) return {FeatureCell::Kind::Ball, atoms_[lane]};
    const std::int64_t tag = tags_[lane];
    if (is_arc(tag)) return {FeatureCell::Kind::Arc, arc_of(tag)};
    return {FeatureCell::Kind::Vertex, static_cast<std::uint32_t>(tag)};
}

void NearestBatch::steps_to_surface(BatchSteps& steps) {
    stepper_.clear();
    others_.clear();
    for (std::uint32_t lane = 0; lane < count_; ++lane) {
        const std::uint32_t point = sorted_[lane];
        if (found(point) && (claims_.owned[lane] != 0 || data_->probe > 0.0))
            stepper_.add(point, get_point(lanes_, lane), cell_of(lane));
        else
            others_.push_back(lane);
    }
    std::size_t to = stepper_.take(steps);
    for (const std::uint32_t lane : others_) {
        const std::uint32_t point = sorted_[lane];
        steps.point[to] = point;
        steps.lanes.settled[to] = 0;
        steps.signed_distance[to] = 0.0;
        if (found(point)) {  // the foot is on the surface: no direction leads there
            const SurfaceStep step = step_to_surface(point);
            steps.set(to, step.point, step.feature);
            steps.lanes.settled[to] = step.settled ? -1 : 0;
        }
        ++to;
    }
}

FeatureLabel NearestBatch::label(std::size_t point) const {
    return label_in(*data_, get_point(*points_, point), cell_of(lane_of_[point]), signed_distance(point));
}

}  // namespace meniscus
