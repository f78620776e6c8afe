// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/spherical_region.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "core/elementary.h"
#include "core/perpendicular.h"

namespace meniscus {
namespace {

constexpr double kPi = std::numbers::pi;

double wrapped_turn(double angle) { return angle < 0.0 ? angle + 2.0 * kPi : angle; }

double rim_sine(const CapPlane& cap) { return std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t)); }

// Whether two caps share ground, one of which may hold the other: their angular radii add up to half a turn, or to more
// than the angle of their axes.
bool caps_overlap(const CapPlane& a, const CapPlane& b) {
    return a.t + b.t <= 0.0 || dot(a.axis, b.axis) > a.t * b.t - rim_sine(a) * rim_sine(b);
}

}  // namespace

void SphericalRegions::measure(std::span<const CapPlane> caps, std::span<const ContourArc> arcs) {
    caps_ = caps;
    contour_ = arcs;
    measured_.resize(arcs.size());
    regions_.clear();
    if (caps.empty()) regions_.push_back({4.0 * kPi, {}});
    if (arcs.empty()) return;
    link_arcs();
    number_loops();
    measure_arcs();
    group_loops();
    add_up();
}

void SphericalRegions::link_arcs() {
    const auto n = static_cast<std::uint32_t>(contour_.size());
    const auto follows = [&](const ContourArc& next, const ContourArc& arc) {
        return next.cap == arc.to && next.from == arc.cap;
    };
    loops_.arc_on.assign(caps_.size(), 0);
    for (std::uint32_t a = 0; a < n; ++a) loops_.arc_on[contour_[a].cap] = a;
    loops_.next.resize(n);
    for (std::uint32_t a = 0; a < n; ++a) {
        const ContourArc& arc = contour_[a];
        loops_.next[a] = arc.from == kWholeCircle ? a : loops_.arc_on[arc.to];
        if (arc.from == kWholeCircle || follows(contour_[loops_.next[a]], arc)) continue;
        for (std::uint32_t b = 0; b < n; ++b)  // few rims have more than one arc
            if (follows(contour_[b], arc)) loops_.next[a] = b;
    }
}

void SphericalRegions::number_loops() {
    constexpr std::uint32_t kUnseen = 0xffffffffU;
    loops_.of_arc.assign(contour_.size(), kUnseen);
    loops_.count = 0;
    for (std::uint32_t a = 0; a < contour_.size(); ++a) {
        if (loops_.of_arc[a] != kUnseen) continue;
        for (std::uint32_t b = a; loops_.of_arc[b] == kUnseen; b = loops_.next[b]) loops_.of_arc[b] = loops_.count;
        ++loops_.count;
    }
}

void SphericalRegions::measure_arcs() {
    region_kernels().find_corners(caps_, contour_, measured_);
    for (std::size_t a = 0; a < contour_.size(); ++a) {
        if (contour_[a].from != kWholeCircle) continue;
        const CapPlane& cap = caps_[contour_[a].cap];
        measured_[a].start = cap.t * cap.axis + rim_sine(cap) * perpendicular(cap.axis);
        measured_[a].corner = 0.0;
    }
    region_kernels().measure_arcs(caps_, contour_, loops_.next, measured_);
}

// A direction on an arc, that part of it after its start.
Vec3 SphericalRegions::point_on(std::size_t arc, double part) const {
    const CapPlane& cap = caps_[contour_[arc].cap];
    const Vec3 e1 = measured_[arc].start - cap.t * cap.axis;
    const double angle = part * measured_[arc].angle;
    return normalised(cap.t * cap.axis + elementary::cos(angle) * e1 + elementary::sin(angle) * cross(e1, cap.axis));
}

std::uint32_t SphericalRegions::count_cap_clusters() const {
    DisjointSets clusters(caps_.size());
    auto count = static_cast<std::uint32_t>(caps_.size());
    for (std::uint32_t a = 0; a < caps_.size(); ++a)
        for (std::uint32_t b = 0; b < a; ++b)
            if (clusters.root(a) != clusters.root(b) && caps_overlap(caps_[a], caps_[b]) && clusters.join(a, b))
                --count;
    return count;
}

// Regions and clusters of caps alternate like a tree whose edges are the loops: regions = 1 + loops - clusters.
void SphericalRegions::group_loops() {
    if (loops_.count == 1) {
        loops_.region.assign(1, 0);
        regions_.assign(1, {});
        return;
    }
    DisjointSets loops(loops_.count);
    const std::uint32_t clusters = count_cap_clusters();
    for (std::uint32_t loop = 1; loop < loops_.count; ++loop) {
        if (clusters >= loops_.count)
            loops.join(0, loop);  // each cluster has one loop: one region
        else if (clusters > 1)
            join_along_walk(loop, loops);
    }
    loops_.region = loops.numbers();
    regions_.assign(set_count(loops_.region), {});
}

// Where the great circle from one direction to another crosses the contour.
std::vector<SphericalRegions::Crossing> SphericalRegions::walk(const Vec3& from, const Vec3& to) const {
    std::vector<Crossing> crossings;
    const Vec3 normal = cross(from, to);
    const Vec3 ahead = normalised(cross(normal, from));
    const double length = elementary::atan2(dot(to, ahead), dot(to, from));
    for (std::uint32_t a = 0; a < contour_.size(); ++a) {
        const CapPlane& cap = caps_[contour_[a].cap];
        const double c = dot(cap.axis, from);
        const double s = dot(cap.axis, ahead);
        const double amplitude = std::sqrt(c * c + s * s);
        if (amplitude <= std::abs(cap.t)) continue;
        const double top = elementary::atan2(s, c);
        const double half = elementary::acos(cap.t / amplitude);
        for (const bool into_cap : {true, false}) {
            const double at = std::remainder(into_cap ? top - half : top + half, 2.0 * kPi);
            if (at <= 0.0 || at >= length) continue;
            const Vec3 n = elementary::cos(at) * from + elementary::sin(at) * ahead;
            const Vec3 e1 = normalised(measured_[a].start - cap.t * cap.axis);
            const double angle = wrapped_turn(elementary::atan2(dot(n, cross(e1, cap.axis)), dot(n, e1)));
            if (angle <= measured_[a].angle) crossings.push_back({at, into_cap, a});
        }
    }
    std::sort(crossings.begin(), crossings.end(), [](const Crossing& a, const Crossing& b) {
        return std::tie(a.at, a.into_cap, a.arc) < std::tie(b.at, b.into_cap, b.arc);
    });
    return crossings;
}

// Points of a loop to walk from or to: the middle of an arc of it, or more.
std::vector<SphericalRegions::Stand> SphericalRegions::stands_on(std::uint32_t loop, bool many) const {
    constexpr std::size_t kMost = 16;
    std::vector<Stand> stands;
    for (std::uint32_t a = 0; a < contour_.size() && stands.size() < kMost; ++a) {
        if (loops_.of_arc[a] != loop) continue;
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
        const CapPlane& cap = caps_[contour_[at.arc].cap];
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
    const Vec3 ahead = cross(cross(from, to), from);
    const Vec3 arriving = cross(cross(from, to), to);
    std::uint32_t open = dot(ahead, caps_[contour_[a].cap].axis) < 0.0 ? 0 : loops_.count;  // loops_.count: under a cap
    const auto join = [&](std::uint32_t other) {
        if (open < loops_.count) loops.join(other, open);
    };
    for (const Crossing& crossing : walk(from, to)) {
        if (crossing.into_cap) join(loops_.of_arc[crossing.arc]);
        open = crossing.into_cap ? loops_.count : loops_.of_arc[crossing.arc];
    }
    if (dot(arriving, caps_[contour_[b].cap].axis) > 0.0) join(loop);
}

void SphericalRegions::add_up() {
    for (SphericalRegion& region : regions_) region.solid_angle = 2.0;
    for (const std::uint32_t region : loops_.region) regions_[region].solid_angle -= 1.0;
    for (SphericalRegion& region : regions_) region.solid_angle *= 2.0 * kPi;
    for (std::size_t a = 0; a < contour_.size(); ++a) {
        MeasuredArc& arc = measured_[a];
        arc.region = loops_.region[loops_.of_arc[a]];
        SphericalRegion& region = regions_[arc.region];
        region.solid_angle += caps_[contour_[a].cap].t * arc.angle;
        region.solid_angle -= measured_[loops_.next[a]].corner;
        region.vector_area += arc.area;
    }
}

std::uint32_t SphericalRegions::region_of(const Vec3& direction) const {
    if (regions_.size() <= 1) return 0;
    // The first crossing on the way to any loop bounds the region that the way starts in.
    for (std::size_t a = 0; a < measured_.size(); ++a) {
        const Vec3 there = middle(a);
        if (norm(cross(direction, there)) < 1e-9) return measured_[a].region;
        const std::vector<Crossing> crossings = walk(direction, there);
        return measured_[crossings.empty() ? a : crossings.front().arc].region;
    }
    return 0;
}

}  // namespace meniscus
