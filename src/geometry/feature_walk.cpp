// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/feature_walk.h"

#include <cmath>
#include <cstddef>

namespace meniscus {
namespace {

using Data = AccessibleSurface::Data;
using Kind = FeatureCell::Kind;

// How far inside of a cell points must be: Å, or for products of lengths as many Å² and Å³. Two features are equally
// far but for rounding, some 1e-14 Å², up to 3e-7 Å beside their border, since squared distances part with the square.
constexpr double kBorder = 1e-6;

constexpr int kLongestWalk = 12;  // cells

// The cell itself, if p is inside; else that beyond a side by which p is outside; none where no cell is there.
FeatureCell next_from_ball(const Data& data, const FeatureCell& cell, const Vec3& p) {
    const std::uint32_t atom = cell.index;
    const Vec3 q = p - data.atoms.centres[atom];
    const double l = norm(q);
    bool inside = data.exposed[atom] != 0 && l + kBorder < data.rho[atom];
    for (std::uint64_t c = data.cap_begin[atom]; c < data.cap_begin[atom + 1]; ++c) {
        const CapPlane& cap = data.caps[c];
        if (dot(cap.axis, q) + kBorder < cap.t * l) continue;
        if (data.cap_arc[c] != kNoArc) return {Kind::Arc, data.cap_arc[c]};
        inside = false;
    }
    return inside ? cell : FeatureCell{};
}

FeatureCell next_from_arc(const Data& data, const FeatureCell& cell, const Vec3& p) {
    const SasArc& arc = data.arcs[cell.index];
    const Vec3 q = p - arc.centre;
    const double height = dot(arc.axis, q);
    const Vec3 radial = q - height * arc.axis;
    const double from_axis = norm(radial);
    const double off = arc.radius - from_axis;
    if (arc.radius * height + arc.height0 * off < kBorder) return {Kind::Ball, arc.atoms[0]};
    if (arc.height1 * off - arc.radius * height < kBorder) return {Kind::Ball, arc.atoms[1]};
    if (from_axis < kBorder || arc.is_a_point()) return {};
    if (arc.whole_circle() || dot(radial, arc.middle) > arc.cos_half * from_axis + kBorder) return cell;
    const auto squared_distance = [&](std::uint32_t v) { return squared_norm(p - data.vertices[v].position); };
    return {Kind::Vertex, squared_distance(arc.start) < squared_distance(arc.end) ? arc.start : arc.end};
}

FeatureCell next_from_vertex(const Data& data, const FeatureCell& cell, const Vec3& p) {
    const SasVertex& vertex = data.vertices[cell.index];
    const auto [parts, whole] = place_in_vertex_hull(data, vertex, p);
    for (std::size_t k = 0; k < 3; ++k)
        if (parts[k] < kBorder) return {Kind::Arc, vertex.arcs[k]};
    return parts[0] + parts[1] + parts[2] + kBorder < whole ? cell : FeatureCell{};
}

FeatureCell next_cell(const Data& data, const FeatureCell& cell, const Vec3& p) {
    switch (cell.kind) {
        case Kind::Ball:
            return next_from_ball(data, cell, p);
        case Kind::Arc:
            return next_from_arc(data, cell, p);
        case Kind::Vertex:
            return next_from_vertex(data, cell, p);
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
    constexpr double kNear = 2.5;  // Å
    NearestBall best;
    data.atom_tree.for_each_overlapping(Box{p, p}.grown(kNear), [&](std::uint32_t i) {
        if (data.exposed[i] == 0) return;
        const double l = norm(p - data.atoms.centres[i]);
        best.offer(i, data.rho[i] - l, l);
    });
    return {Kind::Ball, best.atom};
}

// Walks from a cell to that of p. Whether it got there; `cell` is where it ended.
bool walk(const Data& data, const Vec3& p, FeatureCell& cell) {
    bool begun_anew = false;
    for (int walked = 0;; ++walked) {
        const FeatureCell next = next_cell(data, cell, p);
        if (next.kind != Kind::None && walked < kLongestWalk) {
            if (next == cell) return true;
            cell = next;
            continue;
        }
        if (begun_anew || beside_ridge(data, cell, p)) return false;
        begun_anew = true;
        walked = 0;
        cell = deepest_ball(data, p);
    }
}

// The number of a cube of space.
constexpr int kCubeBits = 21;  // of it, for each axis
std::uint64_t cube_of(const Vec3& p) {
    constexpr double kCubes = 1.0 / 0.75;  // per Å: cubes are a little smaller than most cells
    const auto along = [](double x) { return static_cast<std::uint64_t>(static_cast<std::int64_t>(kCubes * x)); };
    return along(p.x) + (along(p.y) << kCubeBits) + (along(p.z) << (2 * kCubeBits));
}

// Which landmark a cube has: eight cubes along each axis have some of their own.
std::size_t landmark_of(std::uint64_t cube) {
    constexpr int kLess = kCubeBits - 3;
    return (cube ^ cube >> kLess ^ cube >> (2 * kLess)) % FeatureWalk::kLandmarks;
}

}  // namespace

void FeatureWalk::find(std::span<const Vec3> points, std::span<FeatureCell> cells) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::uint64_t cube = cube_of(points[i]);
        Landmark& landmark = landmarks_[landmark_of(cube)];
        if (landmark.cube == cube) last_ = landmark.cell;
        const bool inside = walk(*data_, points[i], last_);
        landmark = {cube, last_};
        cells[i] = inside ? last_ : FeatureCell{};
    }
}

FeatureLabel label_in(const AccessibleSurface& surface, const FeatureCell& cell, const Vec3& point) {
    const Data& data = surface.data();
    switch (cell.kind) {
        case Kind::Ball: {
            const double depth = data.rho[cell.index] - norm(point - data.atoms.centres[cell.index]);
            return {data.probe - depth, data.atoms.original[cell.index], PatchKind::Contact};
        }
        case Kind::Arc: {
            const double distance = std::sqrt(foot_on_arc(data.arcs[cell.index], point).squared_distance);
            return {data.probe - distance, atom_of_arc(data, cell.index, point), PatchKind::Toroidal};
        }
        default: {
            const double distance = norm(point - data.vertices[cell.index].position);
            return {data.probe - distance, atom_of_vertex(data, cell.index, point), PatchKind::Reentrant};
        }
    }
}

}  // namespace meniscus
