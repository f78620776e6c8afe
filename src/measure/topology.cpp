// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/topology.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "measure/triangle_lanes.h"
#include "measure/vertex_stretches.h"

namespace meniscus {
namespace {

// A triangle (v, from, to) seen from its corner v: one step round v, counter-clockwise.
struct Step {
    VertexId from = 0;
    VertexId to = 0;
};

// Stars of fewer steps than this are examined quickly; longer ones are rare.
constexpr std::uint32_t kHalfStar = HalfStar::kSteps;
constexpr std::uint32_t kShortStar = 2 * kHalfStar;

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

// The triangles round every vertex of one stretch.
class StretchStars {
public:
    StretchStars(VertexId first, std::size_t count)
        : first_(first),
          count_(static_cast<VertexId>(count)),
          sizes_(std::make_unique<std::uint32_t[]>(count)),
          stars_(new HalfStar[count]),
          second_halves_(new HalfStar[count]) {
        for (std::size_t i = 0; i < count; ++i) clear(stars_[i], i);
    }

    // Adds those corners of a triangle that lie within the stretch.
    void add(const Triangle& triangle) {
        const auto [a, b, c] = triangle;
        add_step(a, {b, c});
        add_step(b, {c, a});
        add_step(c, {a, b});
    }

    // After all triangles.
    MeshTopology examine() {
        std::stable_sort(more_.begin(), more_.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
        MeshTopology seen;
        for (std::size_t begin = 0; begin < count_; begin += kStarsAtOnce) {
            const std::size_t count = std::min<std::size_t>(kStarsAtOnce, count_ - begin);
            const std::uint64_t rings =
                triangle_kernels().find_rings({&stars_[begin], count}, &second_halves_[begin], {&sizes_[begin], count});
            for (std::size_t i = begin; i < begin + count; ++i) {
                if ((rings >> (i - begin) & 1) != 0)
                    seen.edges += sizes_[i];
                else
                    examine_star(steps(i), vertex(i), seen);
            }
        }
        return seen;
    }

private:
    static constexpr std::size_t kStarsAtOnce = 64;

    VertexId vertex(std::size_t i) const { return first_ + static_cast<VertexId>(i); }

    void clear(HalfStar& star, std::size_t i) const {
        star.from.fill(vertex(i));
        star.to.fill(vertex(i));
    }

    void add_step(VertexId v, const Step& step) {
        const VertexId i = v - first_;  // beyond all others where it comes before the first
        if (i >= count_) return;
        const std::uint32_t n = sizes_[i]++;
        if (n + 1 < kHalfStar)
            put(step, n, stars_[i]);
        else
            add_to_long_star(i, n, step);
    }

    static void put(const Step& step, std::uint32_t n, HalfStar& star) {
        star.from[n] = step.from;
        star.to[n] = step.to;
    }

    void add_to_long_star(VertexId i, std::uint32_t n, const Step& step) {
        if (n + 1 == kHalfStar) clear(second_halves_[i], i);
        if (n < kHalfStar)
            put(step, n, stars_[i]);
        else if (n < kShortStar)
            put(step, n - kHalfStar, second_halves_[i]);
        else
            more_.emplace_back(i, step);
    }

    std::vector<Step> steps(std::size_t i) const {
        std::vector<Step> steps;
        steps.reserve(sizes_[i]);
        for (std::size_t n = 0; n < std::min(sizes_[i], kShortStar); ++n) {
            const HalfStar& half = n < kHalfStar ? stars_[i] : second_halves_[i];
            steps.push_back({half.from[n % kHalfStar], half.to[n % kHalfStar]});
        }
        const auto first = std::lower_bound(more_.begin(), more_.end(), i,
                                            [](const auto& entry, std::size_t number) { return entry.first < number; });
        for (auto at = first; steps.size() < sizes_[i]; ++at) steps.push_back(at->second);
        return steps;
    }

    VertexId first_;
    VertexId count_;
    std::unique_ptr<std::uint32_t[]> sizes_;
    std::unique_ptr<HalfStar[]> stars_;
    std::unique_ptr<HalfStar[]> second_halves_;       // cleared where the first is full
    std::vector<std::pair<std::size_t, Step>> more_;  // what the short stars had no room for, and whose
};

}  // namespace

MeshTopology examine_topology(std::size_t vertex_count, std::span<const Triangle> triangles) {
    const VertexStretches stretches(vertex_count, triangles);
    const auto examine = [&](std::size_t stretch, std::size_t) {
        StretchStars stars(stretches.first(stretch), stretches.count(stretch));
        stretches.visit_triangles(stretch, [&](const Triangle& triangle, std::size_t) { stars.add(triangle); });
        return Part{stars.examine()};
    };
    MeshTopology topology = parallel_sum<Part>(stretches.size(), 1, examine).seen;
    topology.edges /= 2;
    return topology;
}

std::uint64_t signed_areas(std::span<const Triangle> some) { return triangle_kernels().sum_signed_areas(some); }

MeshTopology topology_of_manifold(std::size_t vertex_count, std::span<const Triangle> triangles,
                                  std::uint64_t areas_of_all) {
    if (areas_of_all != 0) return examine_topology(vertex_count, triangles);
    return {.closed = true, .manifold = true, .edges = triangles.size() / 2 * 3};
}

}  // namespace meniscus
