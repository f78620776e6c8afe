// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/feature_walk.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstddef>

#include "core/bits.h"

namespace meniscus {
namespace {

using Data = AccessibleSurface::Data;
using Kind = FeatureCell::Kind;

constexpr int kLongestWalk = 12;  // cells

// The cell itself, if p is inside; else that beyond a side by which p is outside; none where no cell is there.
FeatureCell next_from_ball(const Data& data, const CellBorder& border, const FeatureCell& cell, const Vec3& p) {
    const std::uint32_t atom = cell.index;
    const Vec3 q = p - data.atoms.centres[atom];
    const double l = norm(q);
    bool inside = data.exposed[atom] != 0 && l + border.length < data.rho[atom];
    for (std::uint64_t c = data.cap_begin[atom]; c < data.cap_begin[atom + 1]; ++c) {
        const CapPlane& cap = data.caps[c];
        if (dot(cap.axis, q) + border.length < cap.t * l) continue;
        if (data.cap_arc[c] != kNoArc) return {Kind::Arc, data.cap_arc[c]};
        inside = false;
    }
    return inside ? cell : FeatureCell{};
}

FeatureCell next_from_arc(const Data& data, const CellBorder& border, const FeatureCell& cell, const Vec3& p) {
    const SasArc& arc = data.arcs[cell.index];
    const ArcFoot foot = foot_on_arc(arc, p);
    const double off = arc.radius - foot.from_axis;
    if (arc.radius * foot.height + arc.height0 * off < border.area) return {Kind::Ball, arc.atoms[0]};
    if (arc.height1 * off - arc.radius * foot.height < border.area) return {Kind::Ball, arc.atoms[1]};
    if (foot.from_axis < border.length || arc.is_a_point()) return {};
    if (dot(foot.radial, arc.middle) > arc.cos_half * foot.from_axis + border.length) return cell;
    const auto squared_distance = [&](std::uint32_t v) { return squared_norm(p - data.vertices[v].position); };
    return {Kind::Vertex, squared_distance(arc.start) < squared_distance(arc.end) ? arc.start : arc.end};
}

FeatureCell next_from_vertex(const Data& data, const CellBorder& border, const FeatureCell& cell, const Vec3& p) {
    const SasVertex& vertex = data.vertices[cell.index];
    const VertexHull hull = vertex_hull(data, vertex);
    const std::array<double, 3> parts = hull.parts_of(p);
    for (std::size_t k = 0; k < 3; ++k)
        if (parts[k] < border.volume) return {Kind::Arc, vertex.arcs[k]};
    return parts[0] + parts[1] + parts[2] + border.volume < hull.whole ? cell : FeatureCell{};
}

FeatureCell next_cell(const Data& data, const CellBorder& border, const FeatureCell& cell, const Vec3& p) {
    switch (cell.kind) {
        case Kind::Ball:
            return next_from_ball(data, border, cell, p);
        case Kind::Arc:
            return next_from_arc(data, border, cell, p);
        case Kind::Vertex:
            return next_from_vertex(data, border, cell, p);
        default:
            return {};
    }
}

// Whether p, outside of a vertex's cell, is where the probe reaches through between the atoms.
bool beside_ridge(const Data& data, const FeatureCell& cell, const Vec3& p) {
    constexpr double kNear = 1.0;  // Å from the surface
    const double reach = data.probe + kNear;
    return cell.kind == Kind::Vertex && squared_norm(p - data.vertices[cell.index].position) < reach * reach;
}

// Of the exposed balls of atoms nearby; the first atom's if there is none.
FeatureCell deepest_ball(const Data& data, const Vec3& p) {
    constexpr double kNear = 0.7;  // Å from the surface
    NearestBall best;
    data.atom_tree.for_each_overlapping(Box{p, p}.grown(data.rho_max - data.probe + kNear), [&](std::uint32_t i) {
        if (data.exposed[i] == 0) return;
        const double l = norm(p - data.atoms.centres[i]);
        best.offer(i, data.rho[i] - l, l);
    });
    return {Kind::Ball, best.atom};
}

// Goes from cell to cell, to the side of each by which p is outside. Whether it got to that of p; `cell` is where it
// ended.
bool follow(const Data& data, const CellBorder& border, const Vec3& p, FeatureCell& cell) {
    for (int walked = 0; walked < kLongestWalk; ++walked) {
        const FeatureCell next = next_cell(data, border, cell, p);
        if (next.kind == Kind::None) return false;
        if (next == cell) return true;
        cell = next;
    }
    return false;
}

// The same, and once more from a ball near p where that led nowhere.
bool walk(const Data& data, const CellBorder& border, const Vec3& p, FeatureCell& cell) {
    if (follow(data, border, p, cell)) return true;
    if (beside_ridge(data, cell, p)) return false;
    cell = deepest_ball(data, p);
    return follow(data, border, p, cell);
}

// The number of a cube of space.
constexpr int kCubeBits = 21;  // of it, for each axis
std::uint64_t cube_of(const Vec3& p) {
    constexpr double kCubes = 1.0 / 1.5;  // per Å: of smaller cubes more are entered for the first time
    constexpr double kFarthest = 1e15;    // Å; what is farther, or no number, has no cube of its own
    const auto along = [](double x) {
        const double from_origin = std::abs(x) < kFarthest ? kCubes * x : 0.0;
        return static_cast<std::uint64_t>(static_cast<std::int64_t>(from_origin));
    };
    return along(p.x) + (along(p.y) << kCubeBits) + (along(p.z) << (2 * kCubeBits));
}

// Which landmark a cube has: eight cubes along each axis have some of their own.
std::size_t landmark_of(std::uint64_t cube) {
    constexpr int kLess = kCubeBits - 3;
    return (cube ^ cube >> kLess ^ cube >> (2 * kLess)) % FeatureWalk::kLandmarks;
}

}  // namespace

void FeatureWalk::find(std::span<const Vec3> points, std::span<FeatureCell> cells) {
    for (std::size_t begin = 0; begin < points.size(); begin += kBatchLanes) {
        const std::size_t count = std::min(points.size() - begin, kBatchLanes);
        find_batch(points.subspan(begin, count), cells.subspan(begin, count));
    }
}

// Only the first of those points walks that share a cell: the others are found in it side by side.
void FeatureWalk::find_batch(std::span<const Vec3> points, std::span<FeatureCell> cells) {
    for (std::size_t i = 0; i < points.size(); ++i) set_point(lanes_, i, points[i]);
    std::uint64_t open = first_bits(points.size());
    while (open != 0) {
        const auto first = static_cast<std::size_t>(std::countr_zero(open));
        if (first != 0 && cells[first - 1].kind != Kind::None) last_ = cells[first - 1];
        const FeatureCell cell = find_one(points[first]);
        cells[first] = cell;
        open &= open - 1;
        if (open == 0 || cell.kind == Kind::None) continue;
        const std::uint64_t found = find_in(cell, open);
        for_each_bit(found, [&](std::size_t i) { cells[i] = cell; });
        open &= ~found;
    }
}

FeatureCell FeatureWalk::find_one(const Vec3& point) {
    const std::uint64_t cube = cube_of(point);
    Landmark& landmark = landmarks_[landmark_of(cube)];
    if (landmark.cube == cube) last_ = landmark.cell;
    const bool inside = walk(*data_, border_, point, last_);
    landmark = {cube, last_};
    return inside ? last_ : FeatureCell{};
}

// Those points of a batch that lie in a cell, bit by bit.
std::uint64_t FeatureWalk::find_in(const FeatureCell& cell, std::uint64_t lanes) const {
    switch (cell.kind) {
        case Kind::Ball: {
            const BallOwner ball{data_->atoms.centres[cell.index], data_->rho[cell.index], true,
                                 data_->caps_of(cell.index)};
            return kernels_.find_in_ball_cell(ball, border_, lanes_, lanes);
        }
        case Kind::Arc:
            return kernels_.find_in_arc_cell(data_->arcs[cell.index], border_, lanes_, lanes);
        default:
            return kernels_.find_in_vertex_cell(vertex_hull(*data_, data_->vertices[cell.index]), border_, lanes_,
                                                lanes);
    }
}

}  // namespace meniscus
