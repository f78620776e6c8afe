// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/nearest_batch.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include "core/bits.h"

namespace meniscus {

// The search for one group of points after the other, and the memory that it works in.
struct NearestBatch::Search {
    // Where the points are, and the balls that may be the deepest somewhere there.
    struct Place {
        const LocalFeatures* local = nullptr;
        Box box;
        Vec3 middle;
        double beyond = 0.0;  // Å by which points within the margin may be outside of all balls
        SphereList contenders;
        double depth_error = 0.0;  // Å, of depths in single precision
    };

    // Groups of points with the same deepest ball, one after the other: this is the order of the lanes.
    struct Groups {
        const LanePoints<double>* points = nullptr;
        std::size_t count = 0;
        LaneArray<std::int32_t> of_point;
        std::vector<std::uint32_t> ends;    // per group and chain: where its lanes end
        LaneArray<std::uint32_t> point_in;  // per lane
        LanePoints<double> lanes;           // the points

        static constexpr std::size_t kChains = 2;

        // A counting sort. Points next to each other mostly have the same group: they count in several chains, or each
        // would have to wait for the one before.
        void sort(std::size_t group_count, LaneArray<std::uint32_t>& lane_of) {
            ends.assign(kChains * group_count, 0);
            const auto end_of = [&](std::size_t i) -> std::uint32_t& {
                return ends[kChains * static_cast<std::size_t>(of_point[i]) + i % kChains];
            };
            const LanePoints<double>& given = *points;
            const std::size_t n = count;
            for (std::size_t i = 0; i < n; ++i) ++end_of(i);
            std::exclusive_scan(ends.begin(), ends.end(), ends.begin(), std::uint32_t{0});
            for (std::size_t i = 0; i < n; ++i) {
                const std::uint32_t lane = end_of(i)++;
                point_in[lane] = static_cast<std::uint32_t>(i);
                lane_of[i] = lane;
                set_point(lanes, lane, get_point(given, i));
            }
        }

        LaneRange lanes_of(std::size_t group) const {
            return {group == 0 ? 0 : ends[kChains * group - 1], ends[kChains * (group + 1) - 1]};
        }
    };

    // Points that no ball owns, and the arc or vertex nearest to each.
    struct OpenPoints {
        std::size_t count = 0;
        LaneArray<std::uint32_t> lanes;
        LanePoints<double> points;
        NearestTags nearest;
        LaneArray<double> numbers;  // distances or curvatures of them
    };

    // Memory for what is soon forgotten.
    struct Scratch {
        LanePoints<double> given;              // points that came one by one
        std::vector<double> depths_in_middle;  // per ball of the lists
        std::vector<std::uint64_t> marks;      // of a list: the features that may matter to the box
        std::vector<SmallBall> small;          // the contenders
        LanePoints<float> small_points;
        Depths depths;
        std::vector<std::uint32_t> chosen;  // of vertices, arcs or points
    };

    Search(const AccessibleSurface& surface, const NearestKernels& with)
        : data(surface.data()), kernels(with), stepper(surface, with) {}

    // Balls that may be deeper somewhere than the one that is deepest in the middle.
    void choose_contenders(std::size_t deepest, double half_diagonal) {
        const SphereList& balls = place.local->balls();
        scratch.marks.resize(std::max(scratch.marks.size(), words_for(balls.size())));
        kernels.mark_contenders(balls, deepest, place.box, scratch.marks.data());
        place.contenders.select(balls, scratch.marks.data());
        // In the middle they are less deep by two diagonals at most.
        const double extent = 5.0 * half_diagonal + 2.0 * data.rho_max - scratch.depths_in_middle[deepest];
        // With coordinates up to m from the middle and u = 2^-24, differences are off by 2 u m each, their norm by
        // (2 √3 + 3) u m, the depth by less than 8 u (m + rho).
        place.depth_error = 8.0 * 0x1p-24 * extent;
    }

    // Settles what single precision can settle: which points are beyond the margin, and whose the others may be.
    void group_points(double margin) {
        constexpr float kInfinity = std::numeric_limits<float>::infinity();
        const SphereList& balls = place.contenders;
        scratch.small.resize(balls.size());
        for (std::size_t b = 0; b < balls.size(); ++b) {
            const Vec3 from = position_in(balls, b) - place.middle;
            scratch.small[b] = {static_cast<float>(from.x), static_cast<float>(from.y), static_cast<float>(from.z),
                                static_cast<float>(balls.column(3)[b])};
        }
        kernels.make_small(*groups.points, place.middle, groups.count, scratch.small_points);
        kernels.find_depths(scratch.small, scratch.small_points, groups.count, scratch.depths);
        const auto above = static_cast<float>(-place.beyond - place.depth_error);
        const auto below = static_cast<float>(data.probe + margin + place.depth_error);
        const auto lead = static_cast<float>(2.0 * place.depth_error);
        const DepthLimits limits{.above = std::nextafter(above, -kInfinity),
                                 .below = std::nextafter(below, kInfinity),
                                 .lead = std::nextafter(lead, kInfinity),
                                 .balls = static_cast<std::int32_t>(balls.size())};
        kernels.group_points(scratch.depths, limits, groups.count, groups.of_point);
    }

    // In the order of the lanes: kernels write beyond the end of a range.
    void claim_by_groups(Answers& answers) {
        const std::size_t balls = place.contenders.size();
        for (std::size_t b = 0; b < balls; ++b)
            if (const LaneRange lanes = groups.lanes_of(b); lanes.end > lanes.begin) claim_by_ball(b, lanes, answers);
        const LaneRange doubtful = groups.lanes_of(balls + kDoubtfulGroup);
        for (std::size_t lane = doubtful.begin; lane < doubtful.end; ++lane)
            claim_by_ball(deepest_exactly(get_point(groups.lanes, lane)), {lane, lane + 1}, answers);
        const auto claim_by_side = [&](double signed_distance, const LaneRange& lanes) {
            BallClaims& claims = answers.claims;
            std::fill(claims.signed_distance.at + lanes.begin, claims.signed_distance.at + lanes.end, signed_distance);
            std::fill(claims.owned.at + lanes.begin, claims.owned.at + lanes.end, 0);
        };
        claim_by_side(answers.margin, groups.lanes_of(balls + kAboveGroup));
        claim_by_side(-answers.margin, groups.lanes_of(balls + kBelowGroup));
    }

    void claim_by_ball(std::size_t contender, const LaneRange& lanes, Answers& answers) const {
        const std::uint32_t atom = place.contenders.index(contender);
        BallOwner ball{position_in(place.contenders, contender),
                       place.contenders.column(3)[contender],
                       data.exposed[atom] != 0,
                       {}};
        if (ball.exposed) ball.caps = data.caps_of(atom);
        kernels.claim(ball, data.probe, groups.lanes, lanes, answers.claims);
        std::fill(answers.atoms.at + lanes.begin, answers.atoms.at + lanes.end, atom);
    }

    std::size_t deepest_exactly(const Vec3& point) const {
        const SphereList& balls = place.contenders;
        double best = -std::numeric_limits<double>::infinity();
        std::size_t deepest = 0;
        for (std::size_t b = 0; b < balls.size(); ++b) {
            const double depth = balls.column(3)[b] - norm(point - position_in(balls, b));
            if (depth > best) deepest = b;
            best = std::max(best, depth);
        }
        return deepest;
    }

    // There is no branch in the loop because it could not be predicted.
    void collect_open(const Answers& answers) {
        const std::size_t end = groups.lanes_of(place.contenders.size() + kDoubtfulGroup).end;
        open.count = 0;
        for (std::size_t lane = 0; lane < end; ++lane) {
            open.lanes[open.count] = static_cast<std::uint32_t>(lane);
            open.count += answers.claims.owned[lane] != 0 ? 0 : 1;
        }
        for (std::size_t k = 0; k < open.count; ++k) set_point(open.points, k, get_point(groups.lanes, open.lanes[k]));
    }

    void offer_edges(double margin) {
        std::fill_n(open.nearest.squared_distance.at, open.count, std::numeric_limits<double>::infinity());
        std::fill_n(open.nearest.tag.at, open.count, 0);
        choose_vertices(margin);
        kernels.offer_vertices(place.local->vertices(), scratch.chosen, open.points, open.count, open.nearest);
        choose_arcs();
        kernels.offer_arcs(data.arcs, scratch.chosen, open.points, open.count, open.nearest);
    }

    void choose_vertices(double margin) {
        const SphereList& vertices = place.local->vertices();
        std::vector<std::uint64_t>& marks = scratch.marks;
        marks.resize(std::max(marks.size(), words_for(vertices.size())));
        kernels.mark_reaching(vertices, margin, place.box, marks.data());
        scratch.chosen.resize(vertices.size());
        scratch.chosen.resize(list_items(marks.data(), vertices.size(), scratch.chosen.data()));
    }

    void choose_arcs() {
        const BoxList& arcs = place.local->arcs();
        std::vector<std::uint64_t>& marks = scratch.marks;
        marks.resize(std::max(marks.size(), words_for(arcs.size())));
        kernels.mark_overlapping(arcs, place.box, marks.data());
        scratch.chosen.resize(arcs.size());
        scratch.chosen.resize(list_items(marks.data(), arcs.size(), scratch.chosen.data()));
        for (std::uint32_t& a : scratch.chosen) a = arcs.index(a);
    }

    void claim_by_edges(Answers& answers) {
        kernels.find_edge_distances(open.nearest, data.probe, open.count, open.numbers);
        for (std::size_t k = 0; k < open.count; ++k) {
            answers.claims.signed_distance[open.lanes[k]] = open.numbers[k];
            answers.tags[open.lanes[k]] = open.nearest.tag[k];
        }
    }

    const AccessibleSurface::Data& data;
    NearestKernels kernels;
    Place place;
    Groups groups;
    OpenPoints open;
    StepBatch stepper;
    Scratch scratch;
};

NearestBatch::NearestBatch(const AccessibleSurface& surface, const NearestKernels& kernels)
    : search_(std::make_unique<Search>(surface, kernels)) {}
NearestBatch::~NearestBatch() = default;

NearestBatch::Claim NearestBatch::start(const LocalFeatures& local, const Box& box, double margin) {
    const AccessibleSurface::Data& data = search_->data;
    Search::Place& place = search_->place;
    std::vector<double>& depths = search_->scratch.depths_in_middle;
    answers_.margin = margin;
    place.local = &local;
    place.beyond = std::max(0.0, margin - data.probe);
    place.box = box;
    place.middle = box.middle();
    if (local.balls().empty()) return Claim::Above;
    if (depths.size() < local.balls().padded_size()) depths.resize(local.balls().padded_size());
    const std::size_t deepest = search_->kernels.find_depths_of(place.middle, local.balls(), depths.data());
    const double half_diagonal = 0.5 * norm(box.high - box.low);
    if (depths[deepest] + half_diagonal < -place.beyond) return Claim::Above;
    if (depths[deepest] - half_diagonal > data.probe + margin) return Claim::Below;
    search_->choose_contenders(deepest, half_diagonal);
    return Claim::Open;
}

void NearestBatch::find(std::span<const Vec3> points) {
    LanePoints<double>& given = search_->scratch.given;
    for (std::size_t i = 0; i < points.size(); ++i) set_point(given, i, points[i]);
    find(given, points.size());
}

void NearestBatch::find(const LanePoints<double>& points, std::size_t count) {
    search_->groups.points = &points;
    search_->groups.count = count;
    search_->group_points(answers_.margin);
    search_->groups.sort(search_->place.contenders.size() + kSpecialGroups, answers_.lane_of);
    search_->claim_by_groups(answers_);
    search_->collect_open(answers_);
    if (search_->open.count > 0) search_->offer_edges(answers_.margin);
    search_->claim_by_edges(answers_);
}

// Evaluates the formula of balls for all lanes: a branch by the kind of feature could not be predicted.
void NearestBatch::find_curvatures() {
    const double probe = search_->data.probe;
    Search::OpenPoints& open = search_->open;
    search_->kernels.find_ball_curvatures(answers_.claims, probe, search_->groups.count, answers_.curvatures);
    search_->kernels.find_edge_curvatures(open.nearest, probe, open.count, open.numbers);
    for (std::size_t k = 0; k < open.count; ++k) answers_.curvatures[open.lanes[k]] = open.numbers[k];
}

void NearestBatch::write(std::span<const std::uint32_t> places, double limit, float* distances, float* curvatures) {
    const NearestKernels& kernels = search_->kernels;
    const std::size_t count = search_->groups.count;
    LaneArray<float> clamped;
    LaneArray<float> clamped_curvatures;
    kernels.clamp(answers_.claims.signed_distance, answers_.margin, count, clamped);
    kernels.clamp(answers_.curvatures, limit, count, clamped_curvatures);
    kernels.clear_beyond(answers_.claims.signed_distance, answers_.margin, count, clamped_curvatures);
    for (std::size_t lane = 0; lane < count; ++lane) {
        const std::uint32_t place = places[search_->groups.point_in[lane]];
        distances[place] = clamped[lane];
        curvatures[place] = clamped_curvatures[lane];
    }
}

Vec3 NearestBatch::foot(std::size_t point) const {
    const AccessibleSurface::Data& data = search_->data;
    const Vec3 p = get_point(*search_->groups.points, point);
    const auto [kind, index] = nearest(point);
    switch (kind) {
        case FeatureCell::Kind::Ball: {
            const Vec3& centre = data.atoms.centres[index];
            return centre + (data.rho[index] / norm(p - centre)) * (p - centre);
        }
        case FeatureCell::Kind::Arc: {
            const SasArc& arc = data.arcs[index];
            const ArcFoot on_arc = foot_on_arc(arc, p);
            return arc.centre + (arc.radius / on_arc.from_axis) * on_arc.radial;
        }
        default:
            return data.vertices[index].position;
    }
}

SurfaceStep NearestBatch::step_to_surface(std::size_t point) const {
    return step_from(search_->data, get_point(*search_->groups.points, point), nearest(point));
}

FeatureCell NearestBatch::Answers::cell_of(std::size_t lane) const {
    if (claims.owned[lane] != 0) return {FeatureCell::Kind::Ball, atoms[lane]};
    const std::int64_t tag = tags[lane];
    if (is_arc(tag)) return {FeatureCell::Kind::Arc, arc_of(tag)};
    return {FeatureCell::Kind::Vertex, static_cast<std::uint32_t>(tag)};
}

void NearestBatch::steps_to_surface(BatchSteps& steps) {
    const Search::Groups& groups = search_->groups;
    StepBatch& stepper = search_->stepper;
    std::vector<std::uint32_t>& others = search_->scratch.chosen;  // points that do not step with the rest
    stepper.clear();
    others.clear();
    for (std::uint32_t lane = 0; lane < groups.count; ++lane) {
        const std::uint32_t point = groups.point_in[lane];
        if (found(point) && (answers_.claims.owned[lane] != 0 || search_->data.probe > 0.0))
            stepper.add(point, get_point(groups.lanes, lane), answers_.cell_of(lane));
        else
            others.push_back(point);
    }
    std::size_t to = stepper.take(steps);
    for (const std::uint32_t point : others) {
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

FeatureCell NearestBatch::nearest(std::size_t point) const { return answers_.cell_of(answers_.lane_of[point]); }

NearestFeature NearestBatch::feature(std::size_t point) const {
    return feature_in(search_->data, get_point(*search_->groups.points, point), nearest(point));
}

FeatureLabel NearestBatch::label(std::size_t point) const {
    return label_in(search_->data, get_point(*search_->groups.points, point), nearest(point), signed_distance(point));
}

}  // namespace meniscus
