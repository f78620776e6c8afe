// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/patch_mender.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <utility>

#include "core/elementary.h"

namespace meniscus {
namespace {

constexpr int kMostChanges = 200;  // of one patch
constexpr double kGain = 1e-3;     // of the tangent: less is not worth a change

// What must hold afterwards unless it did not hold before: triangles face the way the surface does within 60 degrees,
// and over new edges it turns by less than 105 (see working_mesh.h), or hardly more than before.
constexpr double kLeastFacing = 0.5;
constexpr double kTurn = -0.25;
constexpr double kSlack = 0.15;

constexpr double kFlat = 0.1;  // tangent: what parting triangles may leave to be mended afterwards

// Places tried for a vertex: on rings round it, in parts of the mean length of its edges.
constexpr std::array<double, 4> kRings{0.03, 0.08, 0.2, 0.4};
constexpr int kPerRing = 8;

// So many changes, those that begin best, are tried together with moves of what they touch.
constexpr std::size_t kTriedTogether = 16;
constexpr int kSweeps = 3;

bool is_inside(const Box& box, const Vec3& p) { return box.squared_distance(p) == 0.0; }

}  // namespace

PatchMender::PatchMender(MendablePatch part, const SliverOptions& options, const SurfaceProjector& project)
    : patch_(std::move(part.patch)),
      free_(std::move(part.free)),
      held_(std::move(part.held)),
      room_(part.room),
      options_(options),
      project_(project),
      limits_{tangent_of_degrees(options.needed_angle_deg), tangent_of_degrees(options.smallest_angle_deg),
              tangent_of_degrees(options.mended_angle_deg), options.shortest_edge()} {}

void PatchMender::mend() {
    std::vector<std::size_t> stuck;
    for (int i = 0; i < kMostChanges; ++i) {
        const std::optional<std::size_t> worst = worst_triangle(stuck);
        if (!worst) return;
        if (mend_triangle(*worst))
            stuck.clear();
        else
            stuck.push_back(*worst);
    }
}

bool PatchMender::untangle() {
    for (int i = 0; i < kMostChanges; ++i) {
        const auto crossing = first_crossing(patch_, free_);
        if (!crossing || !part(*crossing)) return i > 0;
    }
    return true;
}

// Takes the flip, collapse or split of one of both triangles' edges, with moves round it or without, that leaves the
// fewest crossings.
bool PatchMender::part(const std::pair<std::size_t, std::size_t>& crossing) {
    std::vector<Patch> candidates;
    std::vector<VertexId> corners;
    for (const std::size_t t : {crossing.first, crossing.second}) {
        const Triangle& triangle = patch_.triangles[t];
        corners.insert(corners.end(), triangle.begin(), triangle.end());
        for (std::size_t k = 0; k < 3; ++k) {
            const Edge edge{triangle[k], triangle[(k + 1) % 3]};
            if (auto patch = split(edge)) candidates.push_back(std::move(*patch));
            if (auto patch = flipped(edge)) candidates.push_back(std::move(*patch));
            if (auto patch = collapsed(edge)) candidates.push_back(std::move(*patch));
            if (auto patch = collapsed({edge.second, edge.first})) candidates.push_back(std::move(*patch));
        }
    }
    for (std::size_t i = candidates.size(); i-- > 0;) {
        Patch relaxed = candidates[i];
        relax(relaxed, touched_by(relaxed, corners));
        candidates.push_back(std::move(relaxed));
    }
    candidates.push_back(patch_);
    relax(candidates.back(), corners);
    const Patch* best = nullptr;
    std::pair<std::ptrdiff_t, double> least{0, 0.0};  // crossings more than before, and goodness with its sign changed
    for (const Patch& candidate : candidates) {
        const std::vector<std::size_t> changed = changed_triangles(patch_, candidate);
        const PatchShape before = shape_of(patch_, changed, limits_.shortest);
        const PatchShape after = shape_of(candidate, changed, limits_.shortest);
        const double goodness = after.least_goodness;
        if (goodness < std::min(kFlat, before.least_goodness) || makes_short_edges(before, after)) continue;
        const std::pair mark{static_cast<std::ptrdiff_t>(count_crossings(candidate, changed)) -
                                 static_cast<std::ptrdiff_t>(count_crossings(patch_, changed)),
                             -goodness};
        if (mark.first >= 0 || mark >= least) continue;
        least = mark;
        best = &candidate;
    }
    if (best == nullptr) return false;
    patch_ = Patch(*best);
    return true;
}

std::vector<VertexId> PatchMender::touched_by(const Patch& candidate, std::vector<VertexId> corners) const {
    for (const std::size_t t : changed_triangles(patch_, candidate))
        corners.insert(corners.end(), candidate.triangles[t].begin(), candidate.triangles[t].end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

std::optional<std::size_t> PatchMender::worst_triangle(const std::vector<std::size_t>& stuck) const {
    std::optional<std::size_t> worst;
    double least = limits_.wanted;
    for (std::size_t t = 0; t < patch_.triangles.size(); ++t) {
        const Triangle& corners = patch_.triangles[t];
        if (!patch_.has(t) || !is_free(corners)) continue;
        const double goodness = patch_.goodness(corners, limits_.shortest);
        if (goodness >= least || std::find(stuck.begin(), stuck.end(), t) != stuck.end()) continue;
        least = goodness;
        worst = t;
    }
    return worst;
}

bool PatchMender::mend_triangle(std::size_t triangle) {
    const Triangle corners = patch_.triangles[triangle];
    return try_flips(corners, triangle) || try_moves(corners, triangle) || try_collapses(corners, triangle) ||
           (patch_.goodness(corners, limits_.shortest) < limits_.needed &&
            (try_together(corners, triangle, false) || try_together(corners, triangle, true)));
}

bool PatchMender::try_flips(const Triangle& corners, std::size_t triangle) {
    for (std::size_t k = 0; k < 3; ++k) {
        auto candidate = flipped({corners[k], corners[(k + 1) % 3]});
        if (candidate && take_if_enough(*candidate, triangle)) return true;
    }
    return false;
}

bool PatchMender::try_moves(const Triangle& corners, std::size_t triangle) {
    for (const VertexId v : corners) {
        Patch candidate = patch_;
        move(candidate, v);
        if (take_if_enough(candidate, triangle)) return true;
    }
    return false;
}

bool PatchMender::try_collapses(const Triangle& corners, std::size_t triangle) {
    for (std::size_t k = 0; k < 3; ++k)
        for (const Edge& edge : {Edge{corners[k], corners[(k + 1) % 3]}, Edge{corners[(k + 1) % 3], corners[k]}}) {
            auto candidate = collapsed(edge);
            if (candidate && take_if_enough(*candidate, triangle)) return true;
        }
    return false;
}

// Tries flips and collapses round the triangle, or else splits, each with moves of the corners of what it changed, and
// takes the best of all.
bool PatchMender::try_together(const Triangle& corners, std::size_t triangle, bool splits) {
    ++hard_tries_;
    std::vector<Candidate> candidates;
    const auto add = [&](std::optional<Patch>&& patch) {
        if (!patch) return;
        const double goodness = shape_of(*patch, changed_triangles(patch_, *patch), limits_.shortest).least_goodness;
        candidates.push_back({std::move(*patch), goodness});
    };
    for (const auto& [a, b] : edges_round(corners)) {
        if (!splits && a < b) add(flipped({a, b}));
        if (!splits) add(collapsed({a, b}));
        if (splits && a < b) add(split({a, b}));
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Candidate& a, const Candidate& b) { return a.goodness > b.goodness; });
    if (candidates.size() > kTriedTogether) candidates.resize(kTriedTogether);
    candidates.push_back({patch_, 0.0});
    const Candidate* best = nullptr;
    for (Candidate& candidate : candidates) {
        relax(candidate.patch, touched_by(candidate.patch, {corners.begin(), corners.end()}));
        const std::optional<double> goodness =
            judge(candidate.patch, triangle, best == nullptr ? -1.0 : best->goodness + kGain);
        if (!goodness) continue;
        candidate.goodness = *goodness;
        best = &candidate;
    }
    if (best == nullptr) return false;
    patch_ = best->patch;
    return true;
}

std::vector<PatchMender::Edge> PatchMender::edges_round(const Triangle& corners) const {
    std::vector<Edge> edges;
    for (const VertexId v : corners)
        for (const std::size_t t : patch_.star(v))
            for (std::size_t k = 0; k < 3; ++k) {
                const VertexId a = patch_.triangles[t][k];
                const VertexId b = patch_.triangles[t][(k + 1) % 3];
                edges.emplace_back(a, b);
                edges.emplace_back(b, a);
            }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
    return edges;
}

std::optional<Patch> PatchMender::flipped(const Edge& edge) const {
    if (is_held(edge) || !is_between_free(edge)) return std::nullopt;
    Patch patch = patch_;
    return patch.flip(edge.first, edge.second) ? std::optional(std::move(patch)) : std::nullopt;
}

std::optional<Patch> PatchMender::collapsed(const Edge& edge) const {
    if ((held_[edge.first] && !is_along_ridge(edge)) || !is_between_free(edge)) return std::nullopt;
    Patch patch = patch_;
    return patch.collapse(edge.first, edge.second) ? std::optional(std::move(patch)) : std::nullopt;
}

bool PatchMender::makes_short_edges(const PatchShape& before, const PatchShape& after) const {
    return after.shortest < std::min(limits_.shortest * limits_.shortest, before.shortest);
}

bool PatchMender::is_between_free(const Edge& edge) const {
    if (!free_[edge.first] || !free_[edge.second]) return false;
    const std::optional<Patch::Sides> sides = patch_.sides(edge.first, edge.second);
    return sides && free_[sides->left_corner] && free_[sides->right_corner];
}

// Ridges may become shorter along themselves; their ends and forks stay.
bool PatchMender::is_along_ridge(const Edge& edge) const {
    if (!is_held(edge)) return false;
    std::size_t corners = 0;  // each neighbour is one of two triangles
    for (const std::size_t t : patch_.star(edge.first))
        for (const VertexId v : patch_.triangles[t]) corners += v != edge.first && held_[v] ? 1 : 0;
    return corners == 4;
}

std::optional<Patch> PatchMender::split(const Edge& edge) {
    if (is_held(edge) || !is_between_free(edge)) return std::nullopt;
    Patch patch = patch_;
    if (!patch.split(edge.first, edge.second)) return std::nullopt;
    project_(std::span(&patch.points.back(), 1));
    if (free_.size() < patch.points.size()) {
        free_.push_back(true);
        held_.push_back(false);
    }
    return is_inside(room_, patch.points.back().position) ? std::optional(std::move(patch)) : std::nullopt;
}

std::optional<double> PatchMender::judge(const Patch& candidate, std::size_t triangle, double at_least) const {
    std::vector<std::size_t> changed = changed_triangles(patch_, candidate);
    if (changed.empty()) return std::nullopt;
    if (!std::binary_search(changed.begin(), changed.end(), triangle))
        changed.insert(std::lower_bound(changed.begin(), changed.end(), triangle), triangle);
    const PatchShape before = shape_of(patch_, changed, limits_.shortest);
    const PatchShape after = shape_of(candidate, changed, limits_.shortest);
    const double longest = options_.longest_edge * options_.longest_edge;
    const bool new_edges = candidate.triangles != patch_.triangles;
    if (after.least_goodness < std::max(at_least, before.least_goodness + kGain) ||
        after.facing < std::min(kLeastFacing, before.facing) ||
        (new_edges && after.turn < std::min(kTurn, before.turn - kSlack)) ||
        after.longest > std::max(longest, before.longest) || makes_short_edges(before, after))
        return std::nullopt;
    const std::size_t crossings = count_crossings(candidate, changed);
    if (crossings > 0 && crossings > count_crossings(patch_, changed)) return std::nullopt;
    return after.least_goodness;
}

bool PatchMender::take_if_enough(Patch& candidate, std::size_t triangle) {
    if (!judge(candidate, triangle, limits_.enough)) return false;
    patch_ = std::move(candidate);
    return true;
}

void PatchMender::relax(Patch& patch, const std::vector<VertexId>& vertices) {
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        for (const VertexId v : vertices) move(patch, v);
}

// Moves a vertex to the place near it that makes the best triangles.
void PatchMender::move(Patch& patch, VertexId v) {
    if (!free_[v] || held_[v]) return;
    const std::vector<std::size_t> star = patch.star(v);
    if (star.empty()) return;
    const PatchShape before = shape_of(patch, star, limits_.shortest);
    if (before.least_goodness >= limits_.enough) return;
    double length = 0.0;
    for (const std::size_t t : star)
        for (const VertexId w : patch.triangles[t]) length += norm(patch.at(w) - patch.at(v));
    SurfacePoint best = patch.points[v];
    double least = before.least_goodness;
    for (const SurfacePoint& place : places_round(best, length / (2.0 * static_cast<double>(star.size())))) {
        if (!is_inside(room_, place.position)) continue;
        patch.points[v] = place;
        const PatchShape after = shape_of(patch, star, limits_.shortest);
        if (after.least_goodness <= least || after.facing < std::min(kLeastFacing, before.facing)) continue;
        least = after.least_goodness;
        best = place;
    }
    patch.points[v] = best;
}

std::vector<SurfacePoint> PatchMender::places_round(const SurfacePoint& centre, double step) const {
    const Vec3 axis = std::abs(centre.normal.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
    const Vec3 u = normalised(cross(centre.normal, axis));
    const Vec3 w = cross(centre.normal, u);
    std::vector<SurfacePoint> places;
    places.reserve(kRings.size() * kPerRing);
    for (const double ring : kRings)
        for (int k = 0; k < kPerRing; ++k) {
            const double angle = 2.0 * std::numbers::pi * k / kPerRing;
            places.push_back(centre);
            places.back().position += ring * step * (elementary::cos(angle) * u + elementary::sin(angle) * w);
        }
    project_(places);
    return places;
}

}  // namespace meniscus
