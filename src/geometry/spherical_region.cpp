// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/spherical_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace meniscus {
namespace {

constexpr double kPi = std::numbers::pi;

double wrapped_turn(double angle) { return angle < 0.0 ? angle + 2.0 * kPi : angle; }

double rim_sine(const Cap& cap) { return std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t)); }

// Whether two caps share ground: one holds the other, or their rims cross.
bool caps_overlap(const Cap& a, const Cap& b) {
    const double angle = std::atan2(norm(cross(a.axis, b.axis)), dot(a.axis, b.axis));
    return angle < std::acos(std::clamp(a.t, -1.0, 1.0)) + std::acos(std::clamp(b.t, -1.0, 1.0));
}

}  // namespace

void SphericalRegions::measure(std::span<const Cap> caps, std::span<const ContourArc> arcs,
                               std::span<const std::uint32_t> kept) {
    caps_.assign(caps.begin(), caps.end());
    contour_ = arcs;
    kept_ = kept;
    measured_.clear();
    regions_.clear();
    if (kept.empty()) regions_.push_back({4.0 * kPi, {}});
    if (arcs.empty()) return;
    link_loops();
    measure_arcs();
    group_loops();
    add_up();
}

// Every arc ends where the next one starts.
void SphericalRegions::measure_arcs() {
    measured_.resize(contour_.size());
    for (std::size_t a = 0; a < contour_.size(); ++a) {
        const ContourArc& arc = contour_[a];
        const Cap& cap = caps_[arc.cap];
        measured_[a].start = arc.from == kWholeCircle ? cap.t * cap.axis + rim_sine(cap) * perpendicular(cap.axis)
                                                      : rim_crossing(caps_[arc.from], cap);
    }
    for (std::size_t a = 0; a < contour_.size(); ++a) {
        const ContourArc& arc = contour_[a];
        const Cap& cap = caps_[arc.cap];
        MeasuredArc& result = measured_[a];
        result.end = measured_[next_[a]].start;
        result.angle = 2.0 * kPi;
        if (arc.from != kWholeCircle) {
            const Vec3 beside = cross(result.start, cap.axis);  // clockwise around the cap
            const Vec3 outward = result.start - cap.t * cap.axis;
            result.angle = wrapped_turn(std::atan2(dot(result.end, beside), dot(result.end, outward)));
            // The pseudo-angle, of period 4, tells a sweep of nothing from a whole turn.
            if (arc.sweep < 1.0 && result.angle > 1.5 * kPi) result.angle = 0.0;
            if (arc.sweep > 3.0 && result.angle < 0.5 * kPi) result.angle = 2.0 * kPi;
        }
    }
}

// A direction on an arc, that part of it after its start.
Vec3 SphericalRegions::point_on(std::size_t arc, double part) const {
    const Cap& cap = caps_[contour_[arc].cap];
    const Vec3 e1 = measured_[arc].start - cap.t * cap.axis;
    const double angle = part * measured_[arc].angle;
    return normalised(cap.t * cap.axis + std::cos(angle) * e1 + std::sin(angle) * cross(e1, cap.axis));
}

void SphericalRegions::link_loops() {
    const auto n = static_cast<std::uint32_t>(contour_.size());
    next_.assign(n, 0);
    for (std::uint32_t a = 0; a < n; ++a) {
        next_[a] = a;
        if (contour_[a].from == kWholeCircle) continue;
        for (std::uint32_t b = 0; b < n; ++b)
            if (contour_[b].cap == contour_[a].to && contour_[b].from == contour_[a].cap) next_[a] = b;
    }
    constexpr std::uint32_t kUnseen = 0xffffffffU;
    loop_.assign(n, kUnseen);
    loops_ = 0;
    for (std::uint32_t a = 0; a < n; ++a) {
        if (loop_[a] != kUnseen) continue;
        for (std::uint32_t b = a; loop_[b] == kUnseen; b = next_[b]) loop_[b] = loops_;
        ++loops_;
    }
}

std::uint32_t SphericalRegions::count_cap_clusters() const {
    DisjointSets clusters(kept_.size());
    auto count = static_cast<std::uint32_t>(kept_.size());
    for (std::uint32_t a = 0; a < kept_.size(); ++a)
        for (std::uint32_t b = 0; b < a; ++b)
            if (clusters.root(a) != clusters.root(b) && caps_overlap(caps_[kept_[a]], caps_[kept_[b]]) &&
                clusters.join(a, b))
                --count;
    return count;
}

// Regions and clusters of caps alternate like a tree whose edges are the loops: regions = 1 + loops - clusters.
void SphericalRegions::group_loops() {
    DisjointSets loops(loops_);
    if (loops_ > 1) {
        const std::uint32_t clusters = count_cap_clusters();
        for (std::uint32_t loop = 1; loop < loops_; ++loop) {
            if (clusters >= loops_)
                loops.join(0, loop);  // each cluster has one loop: one region
            else if (clusters > 1)
                join_along_walk(loop, loops);
        }
    }
    loop_region_ = loops.numbers();
    regions_.assign(set_count(loop_region_), {});
}

// Lists where the great circle from one direction to another crosses the contour.
void SphericalRegions::walk(const Vec3& from, const Vec3& to) const {
    crossings_.clear();
    const Vec3 normal = cross(from, to);
    const Vec3 ahead = normalised(cross(normal, from));
    const double length = std::atan2(dot(to, ahead), dot(to, from));
    for (std::uint32_t a = 0; a < contour_.size(); ++a) {
        const Cap& cap = caps_[contour_[a].cap];
        const double c = dot(cap.axis, from);
        const double s = dot(cap.axis, ahead);
        const double amplitude = std::hypot(c, s);
        if (amplitude <= std::abs(cap.t)) continue;
        const double top = std::atan2(s, c);
        const double half = std::acos(cap.t / amplitude);
        for (const bool into_cap : {true, false}) {
            const double at = std::remainder(into_cap ? top - half : top + half, 2.0 * kPi);
            if (at <= 0.0 || at >= length) continue;
            const Vec3 n = std::cos(at) * from + std::sin(at) * ahead;
            const Vec3 e1 = normalised(measured_[a].start - cap.t * cap.axis);
            const double angle = wrapped_turn(std::atan2(dot(n, cross(e1, cap.axis)), dot(n, e1)));
            if (angle <= measured_[a].angle) crossings_.push_back({at, into_cap, a});
        }
    }
    std::sort(crossings_.begin(), crossings_.end(), [](const Crossing& a, const Crossing& b) { return a.at < b.at; });
}

// Points of a loop to walk from or to: the middle of an arc of it, or more.
std::vector<SphericalRegions::Stand> SphericalRegions::stands_on(std::uint32_t loop, bool many) const {
    constexpr std::size_t kMost = 16;
    std::vector<Stand> stands;
    for (std::uint32_t a = 0; a < contour_.size() && stands.size() < kMost; ++a) {
        if (loop_[a] != loop) continue;
        if (!many) return {{middle(a), a}};
        for (const double part : {0.125, 0.375, 0.625, 0.875}) stands.push_back({point_on(a, part), a});
    }
    return stands;
}

// How far a way between two points of rims is from running along one of these: 1 straight across, 0 along.
double SphericalRegions::steepness(const Stand& from, const Stand& to) const {
    const Vec3 normal = cross(from.point, to.point);
    if (norm(normal) < 1e-6) return 0.0;
    const auto across = [&](const Stand& at) {
        const Cap& cap = caps_[contour_[at.arc].cap];
        return std::abs(dot(normalised(cross(normal, at.point)), cap.axis)) / rim_sine(cap);
    };
    return std::min(across(from), across(to));
}

// A way between two loops that no rounding can take for another one: it may not leave or reach them along a rim, as it
// does, by symmetry, between lattice points.
std::pair<SphericalRegions::Stand, SphericalRegions::Stand> SphericalRegions::way_between(std::uint32_t a,
                                                                                          std::uint32_t b) const {
    constexpr double kSteepEnough = 0.1;
    std::pair best{stands_on(a, false).front(), stands_on(b, false).front()};
    double steepest = steepness(best.first, best.second);
    if (steepest > kSteepEnough) return best;
    for (const Stand& from : stands_on(a, true))
        for (const Stand& to : stands_on(b, true)) {
            const double steep = steepness(from, to);
            if (!(steep > steepest)) continue;
            steepest = steep;
            best = {from, to};
        }
    return best;
}

// Walks from the first loop to another: loops at both ends of an exposed stretch bound the same region.
void SphericalRegions::join_along_walk(std::uint32_t loop, DisjointSets& loops) {
    const auto [first, last] = way_between(0, loop);
    const auto& [from, a] = first;
    const auto& [to, b] = last;
    walk(from, to);
    const Vec3 ahead = cross(cross(from, to), from);
    const Vec3 arriving = cross(cross(from, to), to);
    std::uint32_t open = dot(ahead, caps_[contour_[a].cap].axis) < 0.0 ? 0 : loops_;  // loops_: under a cap
    const auto join = [&](std::uint32_t other) {
        if (open < loops_) loops.join(other, open);
    };
    for (const Crossing& crossing : crossings_) {
        if (crossing.into_cap) join(loop_[crossing.arc]);
        open = crossing.into_cap ? loops_ : loop_[crossing.arc];
    }
    if (dot(arriving, caps_[contour_[b].cap].axis) > 0.0) join(loop);
}

void SphericalRegions::add_up() {
    std::vector<int> loops_of(regions_.size(), 0);
    for (const std::uint32_t region : loop_region_) ++loops_of[region];
    for (std::size_t r = 0; r < regions_.size(); ++r) regions_[r].solid_angle = 2.0 * kPi * (2 - loops_of[r]);
    for (std::size_t a = 0; a < contour_.size(); ++a) {
        const Cap& cap = caps_[contour_[a].cap];
        MeasuredArc& arc = measured_[a];
        arc.region = loop_region_[loop_[a]];
        SphericalRegion& region = regions_[arc.region];
        region.solid_angle += cap.t * arc.angle;
        // ½ ∮ n × dn along the rim, n = t u + s e: the part along u, and the part of the chord.
        const double s2 = 1.0 - cap.t * cap.t;
        region.vector_area += -0.5 * s2 * arc.angle * cap.axis + 0.5 * cap.t * cross(cap.axis, arc.end - arc.start);
        if (contour_[a].to == kWholeCircle) continue;
        const Cap& other = caps_[contour_[a].to];
        const double sine = dot(arc.end, cross(cap.axis, other.axis));
        const double cosine = dot(cap.axis, other.axis) - cap.t * other.t;
        region.solid_angle -= std::atan2(sine, cosine);
    }
}

std::uint32_t SphericalRegions::region_of(const Vec3& direction) const {
    if (regions_.size() <= 1) return 0;
    // The first crossing on the way to any loop bounds the region that the way starts in.
    for (std::size_t a = 0; a < measured_.size(); ++a) {
        const Vec3 there = middle(a);
        if (norm(cross(direction, there)) < 1e-9) return measured_[a].region;
        walk(direction, there);
        return crossings_.empty() ? measured_[a].region : measured_[crossings_.front().arc].region;
    }
    return 0;
}

}  // namespace meniscus
