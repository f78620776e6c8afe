// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/clearance_graph.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/disjoint_sets.h"
#include "tunnels/drilled_block.h"

namespace meniscus {
namespace {

// Of the points of a lattice round a box: the largest clearance at which the lattice's node next to a point is joined
// with the lattice's border, where nodes count as open whose clearance plus `slack` is as large. With half a diagonal
// of its cubes as slack no true way is missed, with as much less none is too much.
double width_on_lattice(const Clearance& clearance, const Vec3& start, double spacing, double slack) {
    const Box box = clearance.box_of_centres().grown(3.0);
    const auto count = [&](double length) { return static_cast<int>(std::ceil(length / spacing)) + 1; };
    const int nx = count(box.high.x - box.low.x);
    const int ny = count(box.high.y - box.low.y);
    const int nz = count(box.high.z - box.low.z);
    const auto number = [&](int x, int y, int z) { return static_cast<std::uint32_t>((z * ny + y) * nx + x); };
    std::vector<double> value(static_cast<std::size_t>(nx) * ny * nz);
    std::vector<std::uint32_t> order(value.size());
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const std::uint32_t i = number(x, y, z);
                value[i] = clearance.at(box.low + spacing * Vec3{1.0 * x, 1.0 * y, 1.0 * z}) + slack;
                order[i] = i;
            }
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return value[a] > value[b]; });
    const Vec3 from = (1.0 / spacing) * (start - box.low);
    const std::uint32_t begin = number(static_cast<int>(std::lround(from.x)), static_cast<int>(std::lround(from.y)),
                                       static_cast<int>(std::lround(from.z)));
    const auto border = static_cast<std::uint32_t>(value.size());
    DisjointSets sets(value.size() + 1);
    std::vector<bool> open(value.size());
    for (const std::uint32_t i : order) {
        open[i] = true;
        const int x = static_cast<int>(i) % nx;
        const int y = static_cast<int>(i) / nx % ny;
        const int z = static_cast<int>(i) / (nx * ny);
        const auto join = [&](int a, int b, int c) {
            if (a < 0 || b < 0 || c < 0 || a >= nx || b >= ny || c >= nz)
                sets.join(i, border);
            else if (open[number(a, b, c)])
                sets.join(i, number(a, b, c));
        };
        join(x - 1, y, z), join(x + 1, y, z), join(x, y - 1, z);
        join(x, y + 1, z), join(x, y, z - 1), join(x, y, z + 1);
        if (sets.root(begin) == sets.root(border)) return value[i];
    }
    return -1.0;
}

TEST(ClearanceGraph, HasTheWidthsOfALatticeBetweenItsBounds) {
    constexpr double kSpacing = 0.3;
    const double reach = 0.5 * std::sqrt(3.0) * kSpacing;
    int compared = 0;
    for (const unsigned seed : {1U, 2U, 3U, 4U, 5U, 6U}) {
        const Clearance clearance(testing::random_beads(seed, 90, 13.0));
        const Box box = clearance.box_of_centres();
        const auto place = [&](const Vec3& p) { return box.squared_distance(p) > 0.0 ? Place::Second : Place::Inside; };
        std::vector<Vec3> starts;
        for (double x = 3.0; x < 11.0; x += 2.0)
            for (double y = 3.0; y < 11.0; y += 2.0)
                for (double z = 3.0; z < 11.0; z += 2.0) starts.push_back({x, y, z});
        const ClearanceGraph graph(clearance, place, find_saddles(clearance, {.box = box, .min_radius = 0.05}), starts);
        const std::vector<bool> closed(graph.passes().size());
        for (std::size_t i = 0; i < starts.size(); ++i) {
            const Vec3 top = graph.way_up(starts[i]).back();
            if (graph.node_of_start(i) <= kSecondEnd) continue;
            const ClearanceGraph::Route route = graph.widest(graph.node_of_start(i), kSecondEnd, closed);
            double width = clearance.at(top);
            for (const Step& step : route.steps) width = std::min(width, graph.passes()[step.pass].saddle.radius);
            const double most = width_on_lattice(clearance, top, kSpacing, reach);
            const double least = width_on_lattice(clearance, top, kSpacing, -0.5 * kSpacing);
            if (!route.found) {
                EXPECT_LT(least, 0.05);
                continue;
            }
            ++compared;
            EXPECT_LE(width, most + 1e-9);
            EXPECT_GE(width, std::min(least, clearance.at(top)) - 1e-9);
            if (compared >= 12) return;
        }
    }
    FAIL() << "too few ways: " << compared;
}

TEST(ClearanceGraph, LeadsThroughWhatIsNotClosed) {
    Atoms atoms = testing::block({10.0, 8.0, 8.0}, [](const Vec3& p) {
        return norm(p) > 5.0 && !(p.z > 0.0 && std::hypot(std::abs(p.x) - 5.0, p.y) < 4.0);
    });
    testing::add_ring(atoms, {-5.0, 0.0, 6.0}, 1.5);
    testing::add_ring(atoms, {5.0, 0.0, 6.0}, 1.6);
    const Clearance clearance(atoms);
    const Box box = clearance.box_of_centres();
    const auto place = [&](const Vec3& p) { return box.squared_distance(p) > 0.0 ? Place::Second : Place::Inside; };
    const Vec3 start{0.3, 0.2, 0.0};
    const ClearanceGraph graph(clearance, place, find_saddles(clearance, {.box = box, .min_radius = 1.0}),
                               std::span(&start, 1));
    std::vector<bool> closed(graph.passes().size());
    const auto narrowest = [&] {
        const ClearanceGraph::Route route = graph.widest(graph.node_of_start(0), kSecondEnd, closed);
        double width = route.found ? 1e300 : -1.0;
        for (const Step& step : route.steps) width = std::min(width, graph.passes()[step.pass].saddle.radius);
        return width;
    };
    EXPECT_NEAR(narrowest(), 1.6, 1e-9);
    const auto close = [&](double radius) {
        for (std::size_t i = 0; i < closed.size(); ++i)
            if (std::abs(graph.passes()[i].saddle.radius - radius) < 1e-9) closed[i] = true;
    };
    close(1.6);
    EXPECT_NEAR(narrowest(), 1.5, 1e-9);
    close(1.5);
    EXPECT_LT(narrowest(), 0.0);
}

}  // namespace
}  // namespace meniscus
