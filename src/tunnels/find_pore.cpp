// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/perpendicular.h"
#include "core/requirements.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "meniscus/tunnels.h"
#include "tunnels/clearance.h"
#include "tunnels/clearance_graph.h"
#include "tunnels/measured_path.h"
#include "tunnels/saddles.h"

namespace meniscus {
namespace {

/// How far atoms reach along a direction, Å.
struct Slab {
    double low = std::numeric_limits<double>::infinity();
    double high = -std::numeric_limits<double>::infinity();
};

Slab slab_of(const Atoms& atoms, const Vec3& direction) {
    Slab slab;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const double height = dot(atoms.centres[i], direction);
        slab.low = std::min(slab.low, height - atoms.radii[i]);
        slab.high = std::max(slab.high, height + atoms.radii[i]);
    }
    return slab;
}

// The region of a pore: round the line through its ends, as far as there are atoms along it.
class Cylinder {
public:
    Cylinder(const Atoms& atoms, const PoreEnds& ends, double reach)
        : from_(ends.from), axis_(normalised(ends.to - ends.from)), reach_(reach), slab_(slab_of(atoms, axis_)) {}

    Place place(const Vec3& point) const {
        const double height = dot(point, axis_);
        if (height <= slab_.low) return Place::First;
        if (height >= slab_.high) return Place::Second;
        const Vec3 from_line = (point - from_) - dot(point - from_, axis_) * axis_;
        return norm(from_line) <= reach_ ? Place::Inside : Place::Outside;
    }

    // The part of a box that may hold points inside.
    Box box(const Box& all) const {
        Box round;
        for (const double height : {slab_.low, slab_.high}) round.include(from_ + (height - dot(from_, axis_)) * axis_);
        round = round.grown(reach_);
        const auto larger = [](const Vec3& a, const Vec3& b) {
            return Vec3{std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
        };
        return {larger(round.low, all.low), -larger(-round.high, -all.high)};
    }

    // Moves first and last points that are beyond the atoms to where the polyline leaves these.
    void cut_ends(std::vector<Vec3>& points) const {
        cut(points[1], points[0]);
        cut(points[points.size() - 2], points.back());
    }

private:
    void cut(const Vec3& inside, Vec3& end) const {
        const double height = dot(end, axis_);
        const double wanted = std::clamp(height, slab_.low, slab_.high);
        const double before = dot(inside, axis_);
        if (wanted != height && before != height)
            end = inside + ((wanted - before) / (height - before)) * (end - inside);
    }

    Vec3 from_;
    Vec3 axis_;
    double reach_;
    Slab slab_;
};

void check(const PoreEnds& ends, const PoreOptions& options) {
    require_positive("min_radius", options.min_radius);
    require_positive("reach", options.reach);
    require_not_negative("start_radius", options.start_radius);
    constexpr double kFarthest = 1e6;  // Å: beyond, coordinates have too few digits
    for (const Vec3& end : {ends.from, ends.to})
        if (!is_finite(end) || !(norm(end) <= kFarthest))
            throw UsageError("an end of the pore is not finite, or farther than 1,000,000 Å from the origin");
    if (!(norm(ends.to - ends.from) > 0.0)) throw UsageError("both ends of the pore are the same");
}

}  // namespace

PoreEnds ends_along(const ExactSurface& exact, const Vec3& point, const Vec3& direction) {
    const double length = norm(direction);
    if (!is_finite(point) || !std::isfinite(length) || !(length > 0.0))
        throw UsageError("the axis of the pore needs a point and a direction with a length");
    const Vec3 axis = (1.0 / length) * direction;
    const Slab slab = slab_of(exact.atoms(), axis);
    const double height = dot(point, axis);
    return {point + (slab.low - height) * axis, point + (slab.high - height) * axis};
}

std::optional<TunnelPath> find_pore(const ExactSurface& exact, const PoreEnds& ends, const PoreOptions& options,
                                    const RunOptions& run) {
    check(ends, options);
    check_threads(run.threads);
    const ThreadLimit limit(run.threads);
    const Clearance clearance(exact.atoms());
    const Cylinder cylinder(exact.atoms(), ends, options.reach);
    if (run.progress) run.progress("saddles", 0.0);
    std::vector<Saddle> saddles =
        find_saddles(clearance, {.box = cylinder.box(clearance.box_of_centres()), .min_radius = options.min_radius});
    std::erase_if(saddles, [&](const Saddle& s) { return cylinder.place(s.position) != Place::Inside; });
    if (run.progress) run.progress("maxima", 0.0);
    const std::array<Vec3, 2> starts{ends.from, ends.to};
    const ClearanceGraph graph(
        clearance, [&](const Vec3& p) { return cylinder.place(p); }, std::move(saddles), starts);
    if (run.progress) run.progress("pore", 0.0);
    const ClearanceGraph::Route route =
        graph.widest(graph.node_of_start(0), graph.node_of_start(1), std::vector<bool>(graph.passes().size()));
    if (!route.found) return std::nullopt;

    Way way;
    // An end outside the molecule is where the way leaves it.
    const auto is_inside = [&](std::size_t i) { return graph.node_of_start(i) > kSecondEnd; };
    if (is_inside(0)) way.append(moved(graph.way_up(starts[0]), options.start_radius));
    for (const Step& step : route.steps) way.append(graph.way_through(step), graph.passes()[step.pass].saddle);
    if (is_inside(1)) {
        std::vector<Vec3> down = moved(graph.way_up(starts[1]), options.start_radius);
        std::reverse(down.begin(), down.end());
        way.append(down);
    }
    if (way.points.size() < 2) return std::nullopt;
    cylinder.cut_ends(way.points);
    const TunnelPath path = measured(clearance, resampled(clearance, way));
    constexpr double kShortest = 0.01;  // Å
    if (path.length < kShortest)
        throw UsageError("both ends of the pore lead up to the same place; choose ends farther apart");
    if (run.progress) run.progress("pore", 1.0);
    if (path.bottleneck.radius < options.min_radius) return std::nullopt;
    return path;
}

}  // namespace meniscus
