// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/clearance_graph.h"

#include <algorithm>
#include <queue>
#include <utility>

#include "core/disjoint_sets.h"
#include "core/odd_direction.h"
#include "core/parallel.h"
#include "tunnels/ascent.h"

namespace meniscus {

struct ClearanceGraph::Foot {
    Vec3 point;
    double clearance = 0.0;
    Place place = Place::Inside;
    double cost = 0.0;
};

namespace {

constexpr double kFirstStep = 0.25;       // Å: away from a saddle, where there is no slope
constexpr double kLeastFirstStep = 1e-8;  // Å
constexpr double kNudge = 1e-6;           // Å
constexpr std::size_t kWaysPerTask = 32;

// The first point of a way up from a saddle, which no atom blocks; the saddle itself where a fourth atom touches the
// ball.
Vec3 leave(const Clearance& clearance, const Saddle& saddle, std::size_t side) {
    const double here = clearance.at(saddle.position) - kClearanceRounding;
    for (double step = kFirstStep; step > kLeastFirstStep; step *= 0.25) {
        const Vec3 next = saddle.position + (side == 0 ? step : -step) * saddle.normal;
        if (clearance.along(saddle.position, next) >= here) return next;
    }
    return saddle.position;
}

// The points of a way up, and the integral of 1/clearance² along it; each step counts with the clearance where it
// begins.
struct WayUp {
    std::vector<Vec3> points;
    double cost = 0.0;

    void add(const Vec3& point, double clearance_before) {
        cost += norm(point - points.back()) / (clearance_before * clearance_before);
        points.push_back(point);
    }
};

void climb_on(Ascent& ascent, const PlaceOf& place, WayUp& way) {
    ascent.climb(way.points.back(), [&](const Vec3& point) {
        way.add(point, ascent.clearance_before());
        return place(point) == Place::Inside;
    });
}

// Continues a way from its last point to a maximum; the new last one may be not inside. In symmetric arrangements ways
// may lead up to a saddle: a place beside it tells.
void climb(const Clearance& clearance, Ascent& ascent, const PlaceOf& place, WayUp& way) {
    while (place(way.points.back()) == Place::Inside) {
        climb_on(ascent, place, way);
        const Vec3 top = way.points.back();
        if (place(top) != Place::Inside) return;
        const double here = clearance.at(top);
        WayUp beside{{top}};
        beside.add(top + kNudge * kOddDirection, here);
        climb_on(ascent, place, beside);
        if (!(clearance.at(beside.points.back()) > here + kNudge)) return;
        way.points.insert(way.points.end(), beside.points.begin() + 1, beside.points.end());
        way.cost += beside.cost;
    }
}

// That of a side of a saddle, from the saddle on.
WayUp way_of_side(const Clearance& clearance, Ascent& ascent, const PlaceOf& place, const Saddle& saddle,
                  std::size_t side) {
    WayUp way{{saddle.position}};
    const Vec3 next = leave(clearance, saddle, side);
    if (next == saddle.position) return way;
    way.add(next, saddle.radius);
    climb(clearance, ascent, place, way);
    return way;
}

}  // namespace

ClearanceGraph::ClearanceGraph(const Clearance& clearance, PlaceOf place, std::vector<Saddle> saddles,
                               std::span<const Vec3> starts)
    : clearance_(clearance), place_(std::move(place)) {
    std::vector<Foot> feet(2 * saddles.size() + starts.size());
    parallel_chunks(saddles.size(), kWaysPerTask, [&](std::size_t begin, std::size_t end) {
        Ascent ascent(clearance_);
        for (std::size_t i = begin; i < end; ++i)
            for (std::size_t side = 0; side < 2; ++side) {
                const WayUp way = way_of_side(clearance_, ascent, place_, saddles[i], side);
                const Vec3& top = way.points.back();
                feet[2 * i + side] = {top, clearance_.at(top), place_(top), way.cost};
            }
    });
    for (std::size_t i = 0; i < starts.size(); ++i) {
        const Vec3 top = way_up(starts[i]).back();
        feet[2 * saddles.size() + i] = {top, clearance_.at(top), place_(top), 0.0};
    }
    for (Saddle& saddle : saddles) passes_.push_back({saddle, {}});
    starts_.resize(starts.size());
    name_nodes(feet);
    by_radius_.resize(passes_.size());
    for (std::uint32_t i = 0; i < by_radius_.size(); ++i) by_radius_[i] = i;
    std::stable_sort(by_radius_.begin(), by_radius_.end(), [&](std::uint32_t a, std::uint32_t b) {
        return passes_[a].saddle.radius > passes_[b].saddle.radius;
    });
}

// Ways up to the same maximum end at the same place but for rounding; the more exactly, the sharper the maximum.
void ClearanceGraph::name_nodes(const std::vector<Foot>& feet) {
    constexpr double kSamePlace = 1e-4;  // Å
    constexpr double kLoss = 1e-9;       // Å of clearance on the way between two places that count as one
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < feet.size(); ++i)
        if (feet[i].place == Place::Inside) order.push_back(i);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return feet[a].point.x < feet[b].point.x; });
    DisjointSets sets(feet.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Foot& a = feet[order[i]];
        for (std::size_t j = i + 1; j < order.size(); ++j) {
            const Foot& b = feet[order[j]];
            if (b.point.x > a.point.x + kSamePlace) break;
            if (norm(a.point - b.point) > kSamePlace || sets.root(order[i]) == sets.root(order[j])) continue;
            if (clearance_.along(a.point, b.point) >= std::min(a.clearance, b.clearance) - kLoss)
                sets.join(order[i], order[j]);
        }
    }
    std::vector<NodeId> node_of_set(feet.size(), kNoNode);
    NodeId next = kSecondEnd + 1;
    for (std::uint32_t i = 0; i < feet.size(); ++i) {
        NodeId node = kNoNode;
        if (feet[i].place == Place::First) node = kFirstEnd;
        if (feet[i].place == Place::Second) node = kSecondEnd;
        if (feet[i].place == Place::Inside) {
            NodeId& number = node_of_set[sets.root(i)];
            if (number == kNoNode) number = next++;
            node = number;
        }
        if (i < 2 * passes_.size())
            passes_[i / 2].legs[i % 2] = {node, feet[i].cost};
        else
            starts_[i - 2 * passes_.size()] = node;
    }
    nodes_ = next;
}

std::vector<Vec3> ClearanceGraph::way_up(const Vec3& start) const {
    Ascent ascent(clearance_);
    WayUp way{{start}};
    climb(clearance_, ascent, place_, way);
    return way.points;
}

std::vector<Vec3> ClearanceGraph::leg(const Saddle& saddle, std::size_t side) const {
    Ascent ascent(clearance_);
    return way_of_side(clearance_, ascent, place_, saddle, side).points;
}

std::vector<Vec3> ClearanceGraph::way_through(const Step& step) const {
    const Saddle& saddle = passes_[step.pass].saddle;
    std::vector<Vec3> points = leg(saddle, step.side);
    std::reverse(points.begin(), points.end());
    const std::vector<Vec3> onwards = leg(saddle, 1 - step.side);
    points.insert(points.end(), onwards.begin() + 1, onwards.end());
    return points;
}

// The radius of the saddle that joins two nodes when saddles are added from the widest on; negative where none does.
double ClearanceGraph::width(NodeId from, NodeId to, const std::vector<bool>& closed) const {
    DisjointSets sets(nodes_);
    for (const std::uint32_t i : by_radius_) {
        const auto& [a, b] = passes_[i].legs;
        if (closed[i] || a.node == kNoNode || b.node == kNoNode) continue;
        sets.join(a.node, b.node);
        if (sets.root(from) == sets.root(to)) return passes_[i].saddle.radius;
    }
    return -1.0;
}

ClearanceGraph::Route ClearanceGraph::widest(NodeId from, NodeId to, const std::vector<bool>& closed) const {
    if (from == kNoNode || to == kNoNode) return {};
    if (from == to) return {true, {}};
    const double least = width(from, to, closed);
    if (least < 0.0) return {};
    std::vector<std::vector<Step>> leaving(nodes_);
    for (const std::uint32_t i : by_radius_) {
        if (passes_[i].saddle.radius < least) break;
        const auto& [a, b] = passes_[i].legs;
        if (closed[i] || a.node == kNoNode || b.node == kNoNode || a.node == b.node) continue;
        leaving[a.node].push_back({i, 0});
        leaving[b.node].push_back({i, 1});
    }
    struct Reached {
        double cost;
        NodeId node;
        bool operator>(const Reached& other) const {
            return cost != other.cost ? cost > other.cost : node > other.node;
        }
    };
    std::vector<double> costs(nodes_, std::numeric_limits<double>::infinity());
    std::vector<Step> arrival(nodes_);
    std::priority_queue<Reached, std::vector<Reached>, std::greater<>> queue;
    costs[from] = 0.0;
    queue.push({0.0, from});
    while (!queue.empty()) {
        const auto [cost, node] = queue.top();
        queue.pop();
        if (node == to) break;
        if (cost > costs[node]) continue;
        for (const Step& step : leaving[node]) {
            const Pass& pass = passes_[step.pass];
            const NodeId next = pass.legs[1 - step.side].node;
            const double now = cost + pass.legs[0].cost + pass.legs[1].cost;
            if (now >= costs[next]) continue;
            costs[next] = now;
            arrival[next] = step;
            queue.push({now, next});
        }
    }
    Route route{true, {}};
    for (NodeId node = to; node != from; node = passes_[arrival[node].pass].legs[arrival[node].side].node)
        route.steps.push_back(arrival[node]);
    std::reverse(route.steps.begin(), route.steps.end());
    return route;
}

}  // namespace meniscus
