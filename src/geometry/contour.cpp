// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contour.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/bits.h"
#include "core/perpendicular.h"

namespace meniscus {
namespace {

#include "geometry/rim_line.inc"

double wrapped(double angle) { return angle + (angle < 0.0 ? 4.0 : 0.0); }

// Monotonic in the angle of (x, y), period 4, no trigonometry; no branch, as any would be taken by chance.
double diamond_angle(double x, double y) {
    const double p = y / (std::abs(x) + std::abs(y));
    return wrapped(x < 0.0 ? 2.0 - p : p);
}

// Of a direction from e1 towards a quarter turn clockwise around the axis, both perpendicular to e1.
double pseudo_angle(const Vec3& axis, const Vec3& e1, const Vec3& n) {
    return diamond_angle(dot(n, e1), dot(n, cross(e1, axis)));
}

constexpr double kNoCap = 4.0;  // stands for t where there is no cap: no direction lies so deep

CapPlane plane_of(const CapColumns& caps, std::size_t k) { return {{caps[0][k], caps[1][k], caps[2][k]}, caps[3][k]}; }

Vec3 point_on_rim(const CapPlane& cap) {
    return cap.t * cap.axis + std::sqrt(std::max(0.0, 1.0 - cap.t * cap.t)) * perpendicular(cap.axis);
}

// Numbers of an arc, by its lane of EightArcs.
Vec3 load3(const double* lane, std::size_t column) {
    constexpr std::size_t kNext = EightArcs::kCount;
    const double* const at = lane + kNext * column;
    return {at[0], at[kNext], at[2 * kNext]};
}
void store3(const Vec3& v, double* lane, std::size_t column) {
    constexpr std::size_t kNext = EightArcs::kCount;
    double* const at = lane + kNext * column;
    at[0] = v.x;
    at[kNext] = v.y;
    at[2 * kNext] = v.z;
}

// Where a cap cuts an arc once.
Vec3 crossing_of(const EightMeetings& meetings, std::size_t lane) { return load3(&meetings.crossing[lane], 0); }

template <class Visit>
void for_each_bit_downwards(unsigned bits, const Visit& visit) {
    while (bits != 0) {
        const std::size_t lane = static_cast<std::size_t>(std::bit_width(bits)) - 1;
        bits ^= 1U << lane;
        visit(lane);
    }
}

}  // namespace

RimCrossing cross_rims(const Cap& a, const Cap& b) {
    const RimLine<double, Vec3> line = line_of_rims(a.axis, a.t, b.axis, b.t);
    const Vec3 off = std::sqrt(line.squared_half) * line.along;
    return {line.discriminant > 0.0, line.middle + off, line.middle - off};
}

Vec3 rim_crossing(const Cap& a, const Cap& b) {
    const RimCrossing crossing = cross_rims(a, b);
    // Rims that only touch by rounding: the touching point lies in the plane of the axes.
    return crossing.crosses ? crossing.onto : normalised(a.t * a.axis + b.t * b.axis);
}

CapPlane OpenArcs::rim(std::size_t a) const {
    return {load3(lane_of(a), EightArcs::kAxis), lane_of(a)[EightArcs::kCount * EightArcs::kT]};
}
Vec3 OpenArcs::start(std::size_t a) const { return load3(lane_of(a), EightArcs::kStart); }
Vec3 OpenArcs::end(std::size_t a) const { return load3(lane_of(a), EightArcs::kEnd); }
void OpenArcs::move_start(std::size_t a, const Vec3& start) { store3(start, lane_of(a), EightArcs::kStart); }
void OpenArcs::move_end(std::size_t a, const Vec3& end) { store3(end, lane_of(a), EightArcs::kEnd); }

void OpenArcs::append(const Arc& arc, const CapPlane& rim, const Vec3& start, const Vec3& end) {
    const std::size_t a = arcs_.size();
    arcs_.push_back(arc);
    if (a == EightArcs::kCount * lanes_.size()) lanes_.emplace_back();
    store3(rim.axis, lane_of(a), EightArcs::kAxis);
    lane_of(a)[EightArcs::kCount * EightArcs::kT] = rim.t;
    move_start(a, start);
    move_end(a, end);
}

void OpenArcs::remove(std::size_t a) {
    const double* const from = lane_of(arcs_.size() - 1);
    double* const to = lane_of(a);
    for (std::size_t c = 0; c < EightArcs::kColumns; ++c) to[EightArcs::kCount * c] = from[EightArcs::kCount * c];
    arcs_[a] = arcs_.back();
    arcs_.pop_back();
}

void ContourBuilder::start(const CapColumns& caps) {
    caps_ = &caps;
    inserted_ = 0;
    open_.clear();
    arcs_.clear();
    kept_.numbers.clear();
    kept_.planes.clear();
}

bool ContourBuilder::build(const CapColumns& caps) {
    start(caps);
    if (caps.size() == 0) return true;
    wait_from(0);
    const std::size_t largest = cap_kernels().find_deepest(caps, waiting_.t.data(), {}, -kNoCap);
    if (!insert_waiting(largest) || !bury_ends() || !insert_rest()) return false;
    list_arcs();
    return true;
}

bool ContourBuilder::build_in_order(const CapColumns& caps) {
    start(caps);
    for (; inserted_ < caps.size() && exposed(); ++inserted_)
        if (!insert(static_cast<std::uint32_t>(inserted_))) return false;
    return true;
}

bool ContourBuilder::extend(const CapColumns& caps) {
    caps_ = &caps;
    wait_from(inserted_);
    if (!insert_rest()) return false;
    list_arcs();
    return true;
}

// Has all caps from one on wait for insertion.
void ContourBuilder::wait_from(std::size_t first) {
    waiting_.t.assign(caps_->padded_size(), kNoCap);
    std::copy((*caps_)[3] + first, (*caps_)[3] + caps_->size(),
              waiting_.t.begin() + static_cast<std::ptrdiff_t>(first));
}

bool ContourBuilder::insert_waiting(std::size_t k) {
    waiting_.t[k] = kNoCap;
    return insert(static_cast<std::uint32_t>(k));
}

// Inserts caps that bury ends of arcs, so that each changes the contour, and few that are inserted are buried later on.
bool ContourBuilder::bury_ends() {
    for (std::size_t a = 0; a < open_.size();) {
        const std::size_t k =
            open_[a].settled ? caps_->size() : cap_kernels().find_deepest(*caps_, waiting_.t.data(), open_.end(a), 0.0);
        if (k == caps_->size()) {
            open_[a++].settled = true;
            continue;
        }
        if (!insert_waiting(k)) return false;
        a = 0;  // arcs have changed their places
    }
    return true;
}

// Inserts the caps that may still change the contour. Large caps come first because they bury others.
bool ContourBuilder::insert_rest() {
    if (!exposed()) return true;
    find_rest();
    const double* const t = (*caps_)[3];
    std::sort(waiting_.chosen.begin(), waiting_.chosen.end(),
              [&](std::uint32_t a, std::uint32_t b) { return t[a] != t[b] ? t[a] < t[b] : a < b; });
    for (std::size_t i = 0; i < waiting_.chosen.size() && exposed(); ++i)
        if (!insert(waiting_.chosen[i])) return false;
    return true;
}

// Chooses the waiting caps that may still change the contour. They are few, and inserting all would cost more; whatever
// is inserted after this choice only buries more.
void ContourBuilder::find_rest() {
    waiting_.marks.resize(words_for(caps_->size()));
    cap_kernels().mark_changing(*caps_, open_.lanes(), open_.size(), kept_.planes, waiting_.marks.data());
    waiting_.chosen.clear();
    for_each_item(waiting_.marks.data(), caps_->size(), [&](std::size_t k) {
        if (waiting_.t[k] != kNoCap) waiting_.chosen.push_back(static_cast<std::uint32_t>(k));
    });
}

bool ContourBuilder::insert(std::uint32_t k) {
    const CapPlane cap = plane_of(*caps_, k);
    crossings_.entries.clear();
    crossings_.exits.clear();
    const bool cuts = cut_arcs(cap);
    if (!crossings_.entries.empty() || !crossings_.exits.empty()) {
        if (!close_rim(cap)) return false;
    } else {  // its rim crosses nothing: all of it is exposed or none
        const Vec3 on_rim = point_on_rim(cap);
        if (is_exposed(cuts ? on_rim : cap.axis))
            open_.append({place(), kWholeCircle, kWholeCircle}, cap, on_rim, on_rim);
        else if (!cuts)
            return true;
    }
    kept_.numbers.push_back(k);
    kept_.planes.push_back(cap);
    return true;
}

// Cuts away what of the arcs lies inside a cap. Returns whether any arc has a part there.
bool ContourBuilder::cut_arcs(const CapPlane& cap) {
    if (meetings_.size() < open_.lanes().size()) meetings_.resize(open_.lanes().size());
    cap_kernels().meet_arcs(open_.lanes(), open_.size(), cap, meetings_.data());
    unsigned touched = 0;
    // From the last to the first: the gap that an arc leaves is filled with the last one.
    for (std::size_t block = (open_.size() + EightArcs::kCount - 1) / EightArcs::kCount; block-- > 0;) {
        const EightMeetings& meetings = meetings_[block];
        touched |= meetings.start_inside | meetings.end_inside | meetings.twice;
        if (meetings.twice == 0)
            cut_once(EightArcs::kCount * block, meetings);
        else
            cut_one_by_one(EightArcs::kCount * block, meetings, cap);
    }
    return touched != 0;
}

// Cuts eight arcs of which none is cut twice.
void ContourBuilder::cut_once(std::size_t begin, const EightMeetings& meetings) {
    for_each_bit_downwards(meetings.end_inside & ~meetings.start_inside,
                           [&](std::size_t lane) { cut_end(begin + lane, crossing_of(meetings, lane)); });
    for_each_bit_downwards(meetings.start_inside & ~meetings.end_inside,
                           [&](std::size_t lane) { cut_start(begin + lane, crossing_of(meetings, lane)); });
    for_each_bit_downwards(meetings.start_inside & meetings.end_inside,
                           [&](std::size_t lane) { open_.remove(begin + lane); });
}

void ContourBuilder::cut_one_by_one(std::size_t begin, const EightMeetings& meetings, const CapPlane& cap) {
    for_each_bit_downwards(meetings.start_inside | meetings.end_inside | meetings.twice, [&](std::size_t lane) {
        const std::size_t a = begin + lane;
        const bool starts_inside = (meetings.start_inside >> lane & 1U) != 0;
        if ((meetings.twice >> lane & 1U) != 0)
            cut_twice(a, starts_inside, cap);
        else if (!starts_inside)
            cut_end(a, crossing_of(meetings, lane));
        else if ((meetings.end_inside >> lane & 1U) == 0)
            cut_start(a, crossing_of(meetings, lane));
        else
            open_.remove(a);
    });
}

void ContourBuilder::cut_end(std::size_t a, const Vec3& crossing) {
    OpenArcs::Arc& arc = open_[a];
    arc.to = place();
    arc.settled = false;
    open_.move_end(a, crossing);
    crossings_.entries.push_back({arc.cap, crossing});
}

void ContourBuilder::cut_start(std::size_t a, const Vec3& crossing) {
    OpenArcs::Arc& arc = open_[a];
    arc.from = place();
    open_.move_start(a, crossing);
    crossings_.exits.push_back({arc.cap, crossing});
}

// An arc with both ends inside the cap, or both outside, that is cut at two places.
void ContourBuilder::cut_twice(std::size_t a, bool starts_inside, const CapPlane& cap) {
    const CapPlane rim = open_.rim(a);
    const RimCrossing crossing = cross_rims({rim.axis, rim.t}, {cap.axis, cap.t});
    const OpenArcs::Arc arc = open_[a];
    const Vec3 end = open_.end(a);
    cut_end(a, crossing.onto);
    if (starts_inside || arc.from == kWholeCircle) {  // one piece is left
        cut_start(a, crossing.back);
    } else {
        crossings_.exits.push_back({arc.cap, crossing.back});
        open_.append({arc.cap, place(), arc.to, arc.settled}, rim, crossing.back, end);
    }
}

// Joins each point where the contour reaches the rim of a cap to the next point where it leaves it.
bool ContourBuilder::close_rim(const CapPlane& cap) {
    if (crossings_.entries.size() != crossings_.exits.size()) return false;
    if (crossings_.entries.size() == 1)
        open_.append({place(), crossings_.entries[0].cap, crossings_.exits[0].cap}, cap, crossings_.entries[0].point,
                     crossings_.exits[0].point);
    else
        close_rim_by_angles(cap);
    return true;
}

void ContourBuilder::close_rim_by_angles(const CapPlane& cap) {
    const Vec3 e1 = perpendicular(cap.axis);
    for (const Crossing& entry : crossings_.entries) {
        const double begin = pseudo_angle(cap.axis, e1, entry.point);
        const auto sweep_to = [&](const Crossing& exit) {
            return wrapped(pseudo_angle(cap.axis, e1, exit.point) - begin);
        };
        const auto exit =
            std::min_element(crossings_.exits.begin(), crossings_.exits.end(),
                             [&](const Crossing& a, const Crossing& b) { return sweep_to(a) < sweep_to(b); });
        open_.append({place(), entry.cap, exit->cap}, cap, entry.point, exit->point);
        *exit = crossings_.exits.back();
        crossings_.exits.pop_back();
    }
}

void ContourBuilder::list_arcs() {
    for (std::size_t a = 0; a < open_.size(); ++a) {
        const OpenArcs::Arc& arc = open_[a];
        ContourArc& listed = arcs_.emplace_back(ContourArc{arc.cap, arc.from, arc.to});
        if (arc.from == kWholeCircle) continue;
        const CapPlane rim = open_.rim(a);
        listed.sweep = pseudo_angle(rim.axis, open_.start(a) - rim.t * rim.axis, open_.end(a));
    }
}

bool ContourBuilder::is_exposed(const Vec3& n) const {
    return std::none_of(kept_.planes.begin(), kept_.planes.end(),
                        [&](const CapPlane& cap) { return dot(n, cap.axis) > cap.t; });
}

}  // namespace meniscus
