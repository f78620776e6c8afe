// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contour.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

namespace meniscus {
namespace {

// Monotonic in the angle of (x, y), period 4, no trigonometry.
double diamond_angle(double x, double y) {
    const double p = y / (std::abs(x) + std::abs(y));
    if (x < 0.0) return 2.0 - p;
    return p < 0.0 ? 4.0 + p : p;
}

double wrapped(double angle) { return angle < 0.0 ? angle + 4.0 : angle; }

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
    const Vec3 w = cross(a.axis, b.axis);
    const double d = squared_norm(w);  // sin² of the axes' angle: 1 - cos² would cancel (near-parallel caps)
    const double g = dot(a.axis, b.axis);
    // Positive when the line in which the rims' planes meet passes inside the unit sphere.
    const double discriminant = d - (a.t * a.t + b.t * b.t - 2.0 * g * a.t * b.t);
    if (!(discriminant > 0.0)) return {};
    const double scale = 1.0 / d;
    const Vec3 middle = scale * ((a.t - g * b.t) * a.axis + (b.t - g * a.t) * b.axis);
    const Vec3 off = scale * std::sqrt(discriminant) * w;
    return {true, middle + off, middle - off};
}

Vec3 rim_crossing(const Cap& a, const Cap& b) {
    const RimCrossing crossing = cross_rims(a, b);
    // Rims that only touch by rounding: the touching point lies in the plane of the axes.
    return crossing.crosses ? crossing.onto : normalised(a.t * a.axis + b.t * b.axis);
}

const ContourBuilder::Frame& ContourBuilder::frame(std::uint32_t cap) {
    if (frame_known_[cap] == 0) {
        const Vec3 e1 = perpendicular(caps_[cap].axis);
        frames_[cap] = {e1, cross(e1, caps_[cap].axis)};
        frame_known_[cap] = 1;
    }
    return frames_[cap];
}

double ContourBuilder::pseudo_angle(std::uint32_t cap, const Vec3& n) {
    const Frame& at = frame(cap);
    return diamond_angle(dot(n, at.e1), dot(n, at.e2));
}

// Most spheres are buried after a few caps: a heap gives the largest without sorting the rest.
std::uint32_t ContourBuilder::take_largest() {
    std::pop_heap(heap_.begin(), heap_.end(), std::greater<>());
    const std::uint32_t cap = heap_.back().second;
    heap_.pop_back();
    return cap;
}

void ContourBuilder::start(std::span<const Cap> caps) {
    caps_ = caps;
    inserted_ = 0;
    frame_known_.clear();
    arcs_.clear();
    extents_.clear();
    kept_.clear();
}

bool ContourBuilder::build(std::span<const Cap> caps) {
    start(caps);
    frame_known_.resize(caps.size());
    if (frames_.size() < caps.size()) frames_.resize(caps.size());
    heap_.clear();
    for (std::uint32_t k = 0; k < caps.size(); ++k) heap_.emplace_back(caps[k].t, k);
    std::make_heap(heap_.begin(), heap_.end(), std::greater<>());
    while (!heap_.empty() && exposed())
        if (!insert(take_largest())) return false;
    return true;
}

bool ContourBuilder::build_in_order(std::span<const Cap> caps) {
    start(caps);
    return extend_in_order(caps);
}

bool ContourBuilder::extend_in_order(std::span<const Cap> caps) {
    caps_ = caps;
    frame_known_.resize(caps.size());
    if (frames_.size() < caps.size()) frames_.resize(caps.size());
    for (; inserted_ < caps.size() && exposed(); ++inserted_)
        if (!insert(static_cast<std::uint32_t>(inserted_))) return false;
    return true;
}

bool ContourBuilder::insert(std::uint32_t k) {
    constexpr double kSlack = 1e-9;  // for rounding; what is not ruled out is examined
    const Cap& cap = caps_[k];
    const double sine = std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t));
    next_arcs_.clear();
    next_extents_.clear();
    entries_.clear();
    exits_.clear();
    bool changed = false;
    bool all_apart = true;
    for (std::size_t a = 0; a < arcs_.size(); ++a) {
        const Extent& extent = extents_[a];
        // Caps whose angular radii add up to less than the angle of their axes are apart.
        const bool apart = cap.t > -extent.cosine &&
                           dot(extent.middle, cap.axis) < cap.t * extent.cosine - sine * extent.sine - kSlack;
        if (apart) {
            keep(arcs_[a], extent);
            continue;
        }
        all_apart = false;
        const Cap& other = caps_[arcs_[a].cap];
        if (const RimCrossing crossing = cross_rims(other, cap); crossing.crosses) {
            const std::size_t before = entries_.size() + exits_.size() + next_arcs_.size();
            cut(a, k, crossing);
            const bool untouched = entries_.size() + exits_.size() + next_arcs_.size() == before + 1;
            changed = changed || !untouched;
        } else if (rim_is_inside(other, cap)) {
            changed = true;
        } else {
            keep(arcs_[a], extent);
        }
    }
    if (!entries_.empty() || !exits_.empty()) {
        if (!close_rim(k)) return false;
    } else if (is_exposed(all_apart ? cap.axis : point_on_rim(k))) {  // it crosses nothing: all of it or none
        keep({.cap = k}, extent_of({.cap = k}, {}, {}));
        changed = true;
    }
    if (!changed) return true;
    kept_.push_back(k);
    std::swap(arcs_, next_arcs_);
    std::swap(extents_, next_extents_);
    return true;
}

// Keeps what of an arc lies outside cap k; along the arc's rim the cap is entered at `onto` and left at `back`.
void ContourBuilder::cut(std::size_t a, std::uint32_t k, const RimCrossing& crossing) {
    const ContourArc& arc = arcs_[a];
    const Extent& extent = extents_[a];
    const double in = pseudo_angle(arc.cap, crossing.onto);
    const double out = pseudo_angle(arc.cap, crossing.back);
    if (arc.from == kWholeCircle) {
        keep_piece({.cap = arc.cap, .from = k, .to = k, .start = out, .sweep = wrapped(in - out)}, k, crossing.back,
                   crossing.onto);
        return;
    }
    const double to_in = wrapped(in - arc.start);
    const double to_out = wrapped(out - arc.start);
    if (to_in < to_out) {  // the arc starts outside the cap
        if (to_in >= arc.sweep) {
            keep(arc, extent);
            return;
        }
        keep_piece({arc.cap, arc.from, k, arc.start, to_in}, k, extent.start, crossing.onto);
        if (to_out < arc.sweep) keep_piece({arc.cap, k, arc.to, out, arc.sweep - to_out}, k, crossing.back, extent.end);
    } else if (to_out < arc.sweep) {  // starts inside the cap and comes out of it
        if (to_in < arc.sweep)
            keep_piece({arc.cap, k, k, out, to_in - to_out}, k, crossing.back, crossing.onto);
        else
            keep_piece({arc.cap, k, arc.to, out, arc.sweep - to_out}, k, crossing.back, extent.end);
    }
}

void ContourBuilder::keep_piece(const ContourArc& piece, std::uint32_t k, const Vec3& start, const Vec3& end) {
    if (piece.to == k) entries_.push_back({pseudo_angle(k, end), piece.cap, end});
    if (piece.from == k) exits_.push_back({pseudo_angle(k, start), piece.cap, start});
    keep(piece, extent_of(piece, start, end));
}

void ContourBuilder::keep(const ContourArc& arc, const Extent& extent) {
    next_arcs_.push_back(arc);
    next_extents_.push_back(extent);
}

// An arc of at most half its rim lies within the cap around the middle of its ends that has them on its rim; a longer
// one within the cap of its own rim, or the complement of that, whichever is smaller.
ContourBuilder::Extent ContourBuilder::extent_of(const ContourArc& arc, const Vec3& start, const Vec3& end) const {
    if (arc.from != kWholeCircle && arc.sweep <= 2.0) {
        const Vec3 sum = start + end;
        if (const double length = norm(sum); length > 0.1) {
            // The sine from the chord: 1 - cosine² would lose arcs of 1e-8 radian.
            return {start, end, (1.0 / length) * sum, 0.5 * length, 0.5 * norm(end - start)};
        }
    }
    const Cap& cap = caps_[arc.cap];
    const double sign = cap.t < 0.0 ? -1.0 : 1.0;
    return {start, end, sign * cap.axis, sign * cap.t, std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t))};
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
        keep(arc, extent_of(arc, entry.point, exit->point));
        *exit = exits_.back();
        exits_.pop_back();
    }
    return true;
}

Vec3 ContourBuilder::point_on_rim(std::uint32_t k) {
    const Cap& cap = caps_[k];
    return cap.t * cap.axis + std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t)) * frame(k).e1;
}

bool ContourBuilder::is_exposed(const Vec3& n) const {
    return std::none_of(kept_.begin(), kept_.end(),
                        [&](std::uint32_t j) { return dot(n, caps_[j].axis) > caps_[j].t; });
}

}  // namespace meniscus
