// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/topology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <memory>
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

// The triangles round every vertex, as numbers of their corners: corner k of triangle t is number 3 t + k. Entries
// first[v] .. first[v + 1] of corners. Index: a type that holds the number of any corner.
template <class Index>
struct Stars {
    std::vector<Index> first;
    std::unique_ptr<Index[]> corners;
};

template <class Index>
Stars<Index> collect_stars(std::size_t vertex_count, std::span<const Triangle> triangles) {
    Stars<Index> stars;
    // While filling, entry v + 1 is where the next corner of v goes; in the end that is where v's corners end.
    stars.first.assign(vertex_count + 2, 0);
    for (const Triangle& t : triangles)
        for (const VertexId v : t) ++stars.first[v + std::size_t{2}];
    std::partial_sum(stars.first.begin(), stars.first.end(), stars.first.begin());
    stars.corners = std::make_unique_for_overwrite<Index[]>(3 * triangles.size());
    Index corner = 0;
    for (const Triangle& t : triangles)
        for (const VertexId v : t) stars.corners[stars.first[v + std::size_t{1}]++] = corner++;
    return stars;
}

Step step_at(const Triangle& triangle, std::size_t corner) {
    return {triangle[corner < 2 ? corner + 1 : 0], triangle[corner > 0 ? corner - 1 : 2]};
}

// Stars of fewer steps than this are examined without a branch; longer ones are rare and sorted instead.
constexpr std::uint32_t kShortStar = 16;

// The steps round a vertex; its own number stands in the rest of `from`, at least once.
struct ShortStar {
    std::array<VertexId, kShortStar> from;
    std::array<VertexId, kShortStar> to;
    std::size_t size = 0;
};

// The usual case, quickly: the steps form one ring. Which step begins where another ends is found by comparing all with
// all; the number of the only one is known from the sum over those found. Taking every step once and coming back only
// with the last proves that no neighbour is visited twice. kWidth: more than there are steps.
template <std::uint32_t kWidth>
bool is_single_ring(const ShortStar& star) {
    std::array<std::uint32_t, kWidth> next;
    for (std::uint32_t k = 0; k < kWidth; ++k) {
        std::uint32_t sum = 0;
        for (std::uint32_t j = 0; j < kWidth; ++j) sum += star.from[j] == star.to[k] ? kWidth + j : 0;
        next[k] = sum - kWidth;
    }
    std::uint32_t at = 0;
    for (std::size_t taken = 1; taken <= star.size; ++taken) {
        at = next[at];
        if (at >= star.size) return false;  // none, several, or the vertex itself
        if (at == 0) return taken == star.size;
    }
    return false;
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

template <class Index>
class StarExaminer {
public:
    StarExaminer(const Stars<Index>& stars, std::span<const Triangle> triangles)
        : stars_(stars), triangles_(triangles) {}

    Part examine(std::size_t begin, std::size_t end) const {
        Part part;
        for (std::size_t v = begin; v < end; ++v) {
            const auto vertex = static_cast<VertexId>(v);
            if (forms_a_ring(vertex))
                part.seen.edges += corners(vertex).size();
            else
                examine_star(steps(vertex), vertex, part.seen);
        }
        return part;
    }

private:
    std::span<const Index> corners(VertexId v) const {
        return {stars_.corners.get() + stars_.first[v], stars_.corners.get() + stars_.first[v + std::size_t{1}]};
    }
    Step step(Index corner) const { return step_at(triangles_[corner / 3], corner % 3); }

    bool forms_a_ring(VertexId v) const {
        constexpr std::uint32_t kHalf = kShortStar / 2;
        ShortStar star;
        star.size = corners(v).size();
        if (star.size < 3 || star.size >= kShortStar) return false;
        star.from.fill(v);
        star.to.fill(v);
        for (std::size_t i = 0; i < star.size; ++i) {
            const auto [from, to] = step(corners(v)[i]);
            star.from[i] = from;
            star.to[i] = to;
        }
        return star.size < kHalf ? is_single_ring<kHalf>(star) : is_single_ring<kShortStar>(star);
    }

    std::vector<Step> steps(VertexId v) const {
        std::vector<Step> steps;
        steps.reserve(corners(v).size());
        for (const Index corner : corners(v)) steps.push_back(step(corner));
        return steps;
    }

    const Stars<Index>& stars_;
    std::span<const Triangle> triangles_;
};

template <class Index>
MeshTopology examine_stars(std::size_t vertex_count, std::span<const Triangle> triangles) {
    const Stars<Index> stars = collect_stars<Index>(vertex_count, triangles);
    const StarExaminer<Index> examiner(stars, triangles);
    const auto examine = [&](std::size_t begin, std::size_t end) { return examiner.examine(begin, end); };
    MeshTopology topology = parallel_sum<Part>(vertex_count, kChunk, examine).seen;
    topology.edges /= 2;
    return topology;
}

}  // namespace

MeshTopology examine_topology(std::size_t vertex_count, std::span<const Triangle> triangles) {
    return triangles.size() <= std::numeric_limits<std::uint32_t>::max() / 3
               ? examine_stars<std::uint32_t>(vertex_count, triangles)
               : examine_stars<std::uint64_t>(vertex_count, triangles);
}

}  // namespace meniscus
