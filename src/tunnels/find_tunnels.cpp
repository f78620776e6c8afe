// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstddef>
#include <iterator>
#include <string>
#include <utility>

#include "core/parallel.h"
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

constexpr double kEndTolerance = 1e-9;  // Å: of the place where a tunnel is cut off

void check(std::span<const Vec3> starts, const TunnelOptions& options) {
    require_positive("min_radius", options.min_radius);
    require_positive("large_probe", options.large_probe);
    require_not_negative("start_radius", options.start_radius);
    require_not_negative("separation", options.separation);
    if (options.count < 1) throw UsageError("count must be at least 1");
    for (std::size_t i = 0; i < starts.size(); ++i)
        if (!is_finite(starts[i])) throw UsageError("start " + std::to_string(i) + ": a coordinate is not finite");
}

// Finds the tunnels of a start, one after the other, each with what the earlier ones leave open.
class TunnelSearch {
public:
    TunnelSearch(const Clearance& clearance, const ClearanceGraph& graph, const ExactSurface& bulk,
                 const TunnelOptions& options)
        : clearance_(clearance), graph_(graph), bulk_(bulk), options_(options) {}

    std::vector<Tunnel> find(std::size_t start, const Vec3& point) {
        const std::vector<Vec3> up = moved(graph_.way_up(point), options_.start_radius);
        closed_.assign(graph_.passes().size(), false);
        std::vector<Tunnel> tunnels;
        while (tunnels.size() < static_cast<std::size_t>(options_.count)) {
            const ClearanceGraph::Route route = graph_.widest(graph_.node_of_start(start), kSecondEnd, closed_);
            if (!route.found) break;
            const TunnelPath path = cut_off(way_of(up, route));
            if (path.length == 0.0 || path.bottleneck.radius < options_.min_radius) break;
            if (std::none_of(tunnels.begin(), tunnels.end(), [&](const Tunnel& t) { return same_end(t.path, path); }))
                tunnels.push_back({start, tunnels.size() + 1, path});
            if (!close_near_bottleneck(route)) break;
        }
        return tunnels;
    }

private:
    Way way_of(const std::vector<Vec3>& up, const ClearanceGraph::Route& route) const {
        Way way;
        way.append(up);
        for (const Step& step : route.steps) way.append(graph_.way_through(step), graph_.passes()[step.pass].saddle);
        return resampled(clearance_, way);
    }

    double outside(const Vec3& point) const { return bulk_.signed_distance(std::span(&point, 1)).front(); }

    // Where the way leaves the SES of the large probe behind its bottleneck.
    TunnelPath cut_off(Way way) const {
        const std::size_t narrowest = bottleneck_of(clearance_, way).point;
        const std::vector<double> distances = bulk_.signed_distance(way.points);
        std::size_t end = narrowest;
        while (end + 1 < way.points.size() && distances[end] < 0.0) ++end;
        if (end > narrowest) {
            Vec3 inside = way.points[end - 1];
            Vec3& outer = way.points[end];
            while (norm(outer - inside) > kEndTolerance) {
                const Vec3 middle = 0.5 * (inside + outer);
                (outside(middle) < 0.0 ? inside : outer) = middle;
            }
        }
        way.points.resize(end + 1);
        while (!way.saddle_points.empty() && way.saddle_points.back() > end) {
            way.saddle_points.pop_back();
            way.saddles.pop_back();
        }
        return measured(clearance_, way);
    }

    // Whether the largest balls at both ends overlap, or the ends are closer than tunnels may be.
    bool same_end(const TunnelPath& a, const TunnelPath& b) const {
        const PathPoint& x = a.points.back();
        const PathPoint& y = b.points.back();
        return norm(x.position - y.position) < std::max(options_.separation, x.radius + y.radius);
    }

    // Closes the passes round the narrowest one of a route; false where the route takes none.
    bool close_near_bottleneck(const ClearanceGraph::Route& route) {
        if (route.steps.empty()) return false;
        const auto radius = [&](const Step& step) { return graph_.passes()[step.pass].saddle.radius; };
        const Step& narrowest = *std::min_element(route.steps.begin(), route.steps.end(),
                                                  [&](const Step& a, const Step& b) { return radius(a) < radius(b); });
        const Vec3 place = graph_.passes()[narrowest.pass].saddle.position;
        for (std::size_t i = 0; i < closed_.size(); ++i)
            if (norm(graph_.passes()[i].saddle.position - place) <= options_.separation) closed_[i] = true;
        return true;
    }

    const Clearance& clearance_;
    const ClearanceGraph& graph_;
    const ExactSurface& bulk_;
    const TunnelOptions& options_;
    std::vector<bool> closed_;  // passes
};

}  // namespace

std::vector<Tunnel> find_tunnels(const ExactSurface& exact, std::span<const Vec3> starts, const TunnelOptions& options,
                                 const RunOptions& run) {
    check(starts, options);
    check_threads(run.threads);
    const ThreadLimit limit(run.threads);
    const Clearance clearance(exact.atoms());
    // Outside the box of the centres all atoms are on one side, so that every way up leads on out.
    const Box box = clearance.box_of_centres();
    const auto place = [&](const Vec3& p) { return box.squared_distance(p) > 0.0 ? Place::Second : Place::Inside; };
    if (run.progress) run.progress("saddles", 0.0);
    std::vector<Saddle> saddles = find_saddles(clearance, {.box = box, .min_radius = options.min_radius});
    if (run.progress) run.progress("maxima", 0.0);
    const ClearanceGraph graph(clearance, place, std::move(saddles), starts);
    if (run.progress) run.progress("tunnels", 0.0);
    const ExactSurface bulk = exact.of_same_atoms({SurfaceKind::Ses, options.large_probe});
    std::vector<std::vector<Tunnel>> of_start(starts.size());
    parallel_for(starts.size(), 1, [&](std::size_t i) {
        of_start[i] = TunnelSearch(clearance, graph, bulk, options).find(i, starts[i]);
    });
    std::vector<Tunnel> tunnels;
    for (std::vector<Tunnel>& found : of_start) std::move(found.begin(), found.end(), std::back_inserter(tunnels));
    if (run.progress) run.progress("tunnels", 1.0);
    return tunnels;
}

}  // namespace meniscus
