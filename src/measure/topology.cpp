// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/topology.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 8192;  // vertices per task: some hundred microseconds

// A triangle (v, from, to) seen from its corner v: one step round v, counter-clockwise.
struct Step {
    VertexId from = 0;
    VertexId to = 0;
};

// The steps round every vertex: entries first[v] .. first[v + 1] of steps.
struct Stars {
    std::vector<std::size_t> first;
    std::vector<Step> steps;
};

Stars collect_stars(std::size_t vertex_count, std::span<const Triangle> triangles) {
    Stars stars;
    // While filling, entry v + 1 is where the next step of v goes; in the end that is where v's steps end.
    stars.first.assign(vertex_count + 2, 0);
    for (const Triangle& t : triangles)
        for (const VertexId v : t) ++stars.first[v + std::size_t{2}];
    std::partial_sum(stars.first.begin(), stars.first.end(), stars.first.begin());
    stars.steps.resize(3 * triangles.size());
    const auto add = [&](VertexId v, VertexId from, VertexId to) {
        stars.steps[stars.first[v + std::size_t{1}]++] = {from, to};
    };
    for (const auto& [a, b, c] : triangles) {
        add(a, b, c);
        add(b, c, a);
        add(c, a, b);
    }
    return stars;
}

// Longest star that is searched step by step; longer ones are rare and sorted instead.
constexpr std::size_t kShortStar = 16;

// The usual case, quickly: the steps form one ring. Sorts them along it; taking every step once and coming back only
// with the last proves that no neighbour is visited twice.
bool is_single_ring(std::span<Step> star, VertexId v) {
    if (star.size() < 3 || star.size() > kShortStar) return false;
    const VertexId start = star[0].from;
    for (std::size_t k = 0;; ++k) {
        const VertexId at = star[k].to;
        if (at == v) return false;
        if (at == start) return k + 1 == star.size();
        std::size_t next = k + 1;
        while (next < star.size() && star[next].from != at) ++next;
        if (next == star.size()) return false;
        std::swap(star[k + 1], star[next]);
    }
}

// One end of a step: a triangle that has the edge v-neighbour, as its first side (leaving v) or its last (coming to v).
struct Spoke {
    VertexId neighbour = 0;
    bool leaving = false;
    std::uint32_t step = 0;
};

std::vector<Spoke> sorted_spokes(std::span<const Step> star) {
    std::vector<Spoke> spokes;
    spokes.reserve(2 * star.size());
    for (std::uint32_t i = 0; i < star.size(); ++i) {
        spokes.push_back({star[i].from, true, i});
        spokes.push_back({star[i].to, false, i});
    }
    std::sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
        return a.neighbour != b.neighbour ? a.neighbour < b.neighbour : a.step < b.step;
    });
    return spokes;
}

// Number of fans: groups of steps that hang together through shared neighbours.
class FanCounter {
public:
    explicit FanCounter(std::size_t steps) : parent_(steps), fans_(steps) {
        std::iota(parent_.begin(), parent_.end(), 0U);
    }
    void join(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a == b) return;
        parent_[a] = b;
        --fans_;
    }
    std::size_t fans() const { return fans_; }

private:
    std::uint32_t root(std::uint32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    std::vector<std::uint32_t> parent_;
    std::size_t fans_;
};

// The general case. Adds the edges at v to topology.edges, so each edge is counted from both its ends.
void examine_star(std::span<const Step> star, VertexId v, MeshTopology& topology) {
    const std::vector<Spoke> spokes = sorted_spokes(star);
    FanCounter fans(star.size());
    for (std::size_t begin = 0, end = 0; begin < spokes.size(); begin = end) {
        std::size_t leaving = 0;
        for (end = begin; end < spokes.size() && spokes[end].neighbour == spokes[begin].neighbour; ++end) {
            leaving += spokes[end].leaving ? 1 : 0;
            fans.join(spokes[begin].step, spokes[end].step);
        }
        const std::size_t coming = end - begin - leaving;
        const bool repeated = spokes[begin].neighbour == v;
        topology.closed = topology.closed && leaving == 1 && coming == 1 && !repeated;
        topology.manifold = topology.manifold && leaving + coming <= 2 && !repeated;
        if (!repeated) ++topology.edges;
    }
    topology.manifold = topology.manifold && fans.fans() == 1;
}

// What is seen from some of the vertices; edges count once per end.
struct Part {
    MeshTopology seen;

    Part& operator+=(const Part& b) {
        seen.closed = seen.closed && b.seen.closed;
        seen.manifold = seen.manifold && b.seen.manifold;
        seen.edges += b.seen.edges;
        return *this;
    }
};

}  // namespace

MeshTopology examine_topology(std::size_t vertex_count, std::span<const Triangle> triangles) {
    Stars stars = collect_stars(vertex_count, triangles);
    const auto examine = [&](std::size_t begin, std::size_t end) {
        Part part;
        for (std::size_t v = begin; v < end; ++v) {
            const auto star = std::span(stars.steps).subspan(stars.first[v], stars.first[v + 1] - stars.first[v]);
            if (is_single_ring(star, static_cast<VertexId>(v)))
                part.seen.edges += star.size();
            else
                examine_star(star, static_cast<VertexId>(v), part.seen);
        }
        return part;
    };
    MeshTopology topology = parallel_sum<Part>(vertex_count, kChunk, examine).seen;
    topology.edges /= 2;
    return topology;
}

}  // namespace meniscus
