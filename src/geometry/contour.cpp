// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contour.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace meniscus {
namespace {

double wrapped(double angle) { return angle + (angle < 0.0 ? 4.0 : 0.0); }

// Monotonic in the angle of (x, y), period 4, no trigonometry; no branch, as any would be taken by chance.
double diamond_angle(double x, double y) {
    const double p = y / (std::abs(x) + std::abs(y));
    return wrapped(x < 0.0 ? 2.0 - p : p);
}

constexpr double kNoCap = 4.0;  // in the place of t: no direction lies so deep

// For rims that do not cross: whether the rim of `a` lies in cap `b`.
bool rim_is_inside(const Cap& a, const Cap& b) { return dot(a.axis, b.axis) * a.t > b.t; }

}  // namespace

// Duff et al. 2017, "Building an orthonormal basis, revisited": no root and no case near a pole.
Vec3 perpendicular(const Vec3& axis) {
    const double sign = std::copysign(1.0, axis.z);
    const double a = -1.0 / (sign + axis.z);
    return {1.0 + sign * axis.x * axis.x * a, sign * axis.x * axis.y * a, -sign * axis.x};
}

RimCrossing cross_rims(const Cap& a, const Cap& b) {
    // Sum and difference of the axes are perpendicular to each other. In their frame nothing cancels, so that caps of
    // spheres that all but coincide keep the order that the perturbation gave them.
    const Vec3 s = a.axis + b.axis;
    const Vec3 e = b.axis - a.axis;
    const double along_s = (a.t + b.t) / squared_norm(s);
    const double along_e = (b.t - a.t) / squared_norm(e);
    const Vec3 middle = along_s * s + along_e * e;
    const Vec3 w = cross(a.axis, e);
    // Positive when the line in which the rims' planes meet passes inside the unit sphere.
    const double discriminant = 1.0 - (along_s * (a.t + b.t) + along_e * (b.t - a.t));
    const Vec3 off = std::sqrt(std::max(0.0, discriminant) / squared_norm(w)) * w;
    return {discriminant > 0.0, middle + off, middle - off};
}

Vec3 rim_crossing(const Cap& a, const Cap& b) {
    const RimCrossing crossing = cross_rims(a, b);
    // Rims that only touch by rounding: the touching point lies in the plane of the axes.
    return crossing.crosses ? crossing.onto : normalised(a.t * a.axis + b.t * b.axis);
}

double ContourBuilder::pseudo_angle(std::uint32_t cap, const Vec3& n) const {
    const Rim& at = rims_[cap];
    return diamond_angle(dot(n, at.e1), dot(n, at.e2));
}

void ContourBuilder::start(std::span<const Cap> caps) {
    caps_ = caps;
    inserted_ = 0;
    arcs_.clear();
    ends_.clear();
    extents_.clear();
    kept_.clear();
    kept_caps_.clear();
    if (rims_.size() < caps.size()) rims_.resize(caps.size());
}

bool ContourBuilder::build(std::span<const Cap> caps) {
    start(caps);
    if (caps.empty()) return true;
    wait_from(0);
    const auto largest =
        std::min_element(caps.begin(), caps.end(), [](const Cap& a, const Cap& b) { return a.t < b.t; });
    return insert_waiting(static_cast<std::size_t>(largest - caps.begin())) && bury_ends() && insert_rest();
}

bool ContourBuilder::build_in_order(std::span<const Cap> caps) {
    start(caps);
    for (; inserted_ < caps.size() && exposed(); ++inserted_)
        if (!insert(static_cast<std::uint32_t>(inserted_))) return false;
    return true;
}

bool ContourBuilder::extend(std::span<const Cap> caps) {
    caps_ = caps;
    if (rims_.size() < caps.size()) rims_.resize(caps.size());
    wait_from(inserted_);
    return insert_rest();
}

// Has all caps from one on wait for insertion.
void ContourBuilder::wait_from(std::size_t first) {
    order_.resize(caps_.size() - first);
    std::iota(order_.begin(), order_.end(), static_cast<std::uint32_t>(first));
    waiting_.resize(order_.size());
    for (std::size_t i = 0; i < order_.size(); ++i) {
        const Cap& cap = caps_[first + i];
        waiting_[0][i] = cap.axis.x;
        waiting_[1][i] = cap.axis.y;
        waiting_[2][i] = cap.axis.z;
        waiting_[3][i] = cap.t;
    }
    std::fill(waiting_[3] + waiting_.size(), waiting_[3] + waiting_.padded_size(), kNoCap);
}

bool ContourBuilder::insert_waiting(std::size_t i) {
    waiting_[3][i] = kNoCap;
    return insert(order_[i]);
}

// Inserts caps that bury ends of arcs, so that each changes the contour, and few that are inserted are buried later on.
bool ContourBuilder::bury_ends() {
    for (std::size_t a = 0; a < arcs_.size();) {
        const std::size_t i = ends_[a].settled ? waiting_.size() : kernels_->find_deepest(waiting_, ends_[a].end);
        if (i == waiting_.size()) {
            ends_[a++].settled = true;
            continue;
        }
        if (!insert_waiting(i)) return false;
        a = 0;  // arcs have changed their places
    }
    return true;
}

// Most change nothing, but to find that out one by one costs a wrong guess of the processor each. Large ones bury
// others.
bool ContourBuilder::insert_rest() {
    if (!exposed()) return true;
    drop_idle();
    std::sort(order_.begin(), order_.end(), [&](std::uint32_t a, std::uint32_t b) { return caps_[a].t < caps_[b].t; });
    for (std::size_t i = 0; i < order_.size() && exposed(); ++i)
        if (!insert(order_[i])) return false;
    return true;
}

bool ContourBuilder::insert(std::uint32_t k) {
    const Cap& cap = caps_[k];
    find_near(cap);
    if (near_count_ == 0 && !is_exposed(cap.axis)) return true;
    const Vec3 e1 = perpendicular(cap.axis);
    rims_[k] = {cap.axis, cap.t, e1, cross(e1, cap.axis)};
    cross_near(cap);
    entries_.clear();
    exits_.clear();
    bool changed = false;
    // From the last to the first: the gap that an arc leaves is filled with the last one.
    for (std::size_t i = near_count_; i-- > 0;) changed = cut(i, k) || changed;
    if (!entries_.empty() || !exits_.empty()) {
        if (!close_rim(k)) return false;
    } else if (const Vec3 anywhere = point_on_rim(k); near_count_ == 0 || is_exposed(anywhere)) {
        append({.cap = k}, {anywhere, anywhere});  // it crosses nothing: all of it or none
        changed = true;
    }
    if (!changed) return true;
    kept_.push_back(k);
    kept_caps_.push_back(cap);
    return true;
}

// Drops those caps to come that were inserted or lie wholly in buried ground: what is inserted in between only buries
// more.
void ContourBuilder::drop_idle() {
    idle_.resize(waiting_.size() + 7);
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
        const double t = waiting_[3][i];
        waiting_[4][i] = std::sqrt(std::max(0.0, 1.0 - t * t));
    }
    kernels_->find_idle(waiting_, extents_, kept_caps_, idle_.data());
    std::size_t kept = 0;
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
        order_[kept] = order_[i];
        kept += idle_[i] > 0.0 || waiting_[3][i] == kNoCap ? 0 : 1;
    }
    order_.resize(kept);
}

// Caps whose angular radii add up to less than the angle of their axes are apart.
void ContourBuilder::find_near(const Cap& cap) {
    const double sine = std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t));
    if (near_.size() < extents_.size()) near_.resize(2 * extents_.size());
    near_count_ = 0;
    for (std::uint32_t a = 0; a < extents_.size(); ++a) {
        const ArcExtent& extent = extents_[a];
        const double gap =
            cap.t * extent.cosine - sine * extent.sine - ArcExtent::kSlack - dot(extent.middle, cap.axis);
        // Radii that may add up to more than half a turn; the middle's length is at most 2.
        const double sum = cap.t + 0.5 * extent.cosine;
        near_[near_count_] = a;
        near_count_ += std::min(gap, sum) > 0.0 ? 0 : 1;
    }
}

// All before the first cut: long chains of arithmetic that overlap as long as no branch hangs on them.
void ContourBuilder::cross_near(const Cap& cap) {
    if (near_rims_.size() < near_count_) near_rims_.resize(2 * near_count_);
    for (std::size_t i = 0; i < near_count_; ++i) near_rims_[i] = arcs_[near_[i]].cap;
    meetings_.resize(near_count_);
    kernels_->find_meetings(rims_, std::span(near_rims_).first(near_count_), cap, meetings_);
}

RimCrossing ContourBuilder::crossing_of(std::size_t i) const {
    const auto point = [&](std::size_t column) {
        return Vec3{meetings_[column][i], meetings_[column + 1][i], meetings_[column + 2][i]};
    };
    return {meetings_[MeetingColumns::kDiscriminant][i] > 0.0, point(MeetingColumns::kOnto),
            point(MeetingColumns::kBack)};
}

// Keeps what of an arc lies outside cap k; false if that is all of it.
bool ContourBuilder::cut(std::size_t i, std::uint32_t k) {
    const std::uint32_t a = near_[i];
    if (meetings_[MeetingColumns::kDiscriminant][i] > 0.0) return cut_at(i, k);
    if (!rim_is_inside(caps_[arcs_[a].cap], caps_[k])) return false;
    remove(a);
    return true;
}

// Along the arc's rim the cap is entered at `onto` and left at `back`.
bool ContourBuilder::cut_at(std::size_t i, std::uint32_t k) {
    const std::uint32_t a = near_[i];
    const ContourArc arc = arcs_[a];
    const Ends ends = ends_[a];
    const RimCrossing crossing = crossing_of(i);
    const double in = meetings_[MeetingColumns::kAngleOnto][i];
    const double out = meetings_[MeetingColumns::kAngleBack][i];
    const Ends between{crossing.back, crossing.onto};
    if (arc.from == kWholeCircle) {
        replace(a, k, {.cap = arc.cap, .from = k, .to = k, .start = out, .sweep = wrapped(in - out)}, between);
        return true;
    }
    const double to_in = wrapped(in - arc.start);
    const double to_out = wrapped(out - arc.start);
    const Ends before{ends.start, crossing.onto};
    const Ends behind{crossing.back, ends.end, ends.settled};
    if (to_in < to_out) {  // the arc starts outside the cap
        if (to_in >= arc.sweep) return false;
        replace(a, k, {arc.cap, arc.from, k, arc.start, to_in}, before);
        if (to_out >= arc.sweep) return true;
        const ContourArc rest{arc.cap, k, arc.to, out, arc.sweep - to_out};
        note_crossings(k, rest, behind);
        append(rest, behind);
    } else if (to_out >= arc.sweep) {
        remove(a);
    } else if (to_in < arc.sweep) {  // starts inside the cap and comes out of it
        replace(a, k, {arc.cap, k, k, out, to_in - to_out}, between);
    } else {
        replace(a, k, {arc.cap, k, arc.to, out, arc.sweep - to_out}, behind);
    }
    return true;
}

void ContourBuilder::note_crossings(std::uint32_t k, const ContourArc& piece, const Ends& ends) {
    if (piece.to == k) entries_.push_back({pseudo_angle(k, ends.end), piece.cap, ends.end});
    if (piece.from == k) exits_.push_back({pseudo_angle(k, ends.start), piece.cap, ends.start});
}

void ContourBuilder::replace(std::size_t a, std::uint32_t k, const ContourArc& piece, const Ends& ends) {
    note_crossings(k, piece, ends);
    arcs_[a] = piece;
    ends_[a] = ends;
    extents_[a] = extent_of(piece, ends);
}

void ContourBuilder::append(const ContourArc& arc, const Ends& ends) {
    arcs_.push_back(arc);
    ends_.push_back(ends);
    extents_.push_back(extent_of(arc, ends));
}

void ContourBuilder::remove(std::size_t a) {
    arcs_[a] = arcs_.back();
    ends_[a] = ends_.back();
    extents_[a] = extents_.back();
    arcs_.pop_back();
    ends_.pop_back();
    extents_.pop_back();
}

// An arc of at most half its rim lies within the cap around the middle of its ends that has them on its rim; a longer
// one within the cap of its own rim, or the complement of that, whichever is smaller.
ArcExtent ContourBuilder::extent_of(const ContourArc& arc, const Ends& ends) const {
    if (arc.from != kWholeCircle && arc.sweep <= 2.0) {
        const Vec3 sum = ends.start + ends.end;
        if (const double length2 = squared_norm(sum); length2 > 0.01)
            return {sum, 0.5 * length2, norm(cross(ends.start, ends.end))};
    }
    const Cap& cap = caps_[arc.cap];
    const double sign = cap.t < 0.0 ? -1.0 : 1.0;
    return {sign * cap.axis, sign * cap.t, std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t))};
}

// Joins each point where the contour reaches the rim of cap k to the next point where it leaves it.
bool ContourBuilder::close_rim(std::uint32_t k) {
    if (entries_.size() != exits_.size()) return false;
    for (const Crossing& entry : entries_) {
        const auto sweep_to = [&](const Crossing& exit) { return wrapped(exit.angle - entry.angle); };
        const auto exit = std::min_element(exits_.begin(), exits_.end(), [&](const Crossing& a, const Crossing& b) {
            return sweep_to(a) < sweep_to(b);
        });
        if (exit == exits_.end()) return false;  // two entries without an exit between them
        const ContourArc arc{k, entry.cap, exit->cap, entry.angle, sweep_to(*exit)};
        append(arc, {entry.point, exit->point});
        *exit = exits_.back();
        exits_.pop_back();
    }
    return true;
}

Vec3 ContourBuilder::point_on_rim(std::uint32_t k) const {
    const Cap& cap = caps_[k];
    return cap.t * cap.axis + std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t)) * rims_[k].e1;
}

bool ContourBuilder::is_exposed(const Vec3& n) const {
    return std::none_of(kept_caps_.begin(), kept_caps_.end(), [&](const Cap& cap) { return dot(n, cap.axis) > cap.t; });
}

}  // namespace meniscus
