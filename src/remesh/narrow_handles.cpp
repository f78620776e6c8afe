// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/narrow_handles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <queue>
#include <utility>
#include <vector>

#include "remesh/half_edges.h"
#include "remesh/self_intersections.h"
#include "remesh/working_mesh.h"

namespace meniscus {
namespace {

// The ends of a cut handle are drawn back by this part of the way to the next vertices, so that they do not touch.
constexpr double kDrawnBack = 1.0 / 3.0;

// Half-edges from vertex to vertex, back to the first.
struct Loop {
    double length = 0.0;
    std::vector<HalfEdge> halves;
};

// Short loops through a vertex, from the tree of shortest ways to the vertices near it.
class LoopSearch {
public:
    LoopSearch(const Mesh& mesh, const HalfEdges& edges, double longest)
        : mesh_(mesh),
          edges_(edges),
          longest_(longest),
          distance_(edges.vertex_slots(), kFar),
          towards_(edges.vertex_slots(), kNoHalfEdge) {}

    // By rising length; none where all of them obviously bound a disc.
    std::vector<Loop> through(VertexId v) {
        reach_from(v);
        std::vector<Loop> loops;
        if (!is_disc_like()) collect(v, loops);
        for (const VertexId u : near_) {
            distance_[u] = kFar;
            towards_[u] = kNoHalfEdge;
        }
        near_.clear();
        return loops;
    }

private:
    static constexpr double kFar = std::numeric_limits<double>::infinity();

    double length(HalfEdge h) const {
        return norm(mesh_.vertices[edges_.target(h)] - mesh_.vertices[edges_.origin(h)]);
    }

    void reach_from(VertexId v) {
        using Entry = std::pair<double, VertexId>;
        std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
        distance_[v] = 0.0;
        near_.push_back(v);
        open.emplace(0.0, v);
        while (!open.empty()) {
            const auto [so_far, u] = open.top();
            open.pop();
            if (so_far > distance_[u]) continue;
            edges_.for_each_leaving(u, [&, so_far = so_far](HalfEdge h) {
                const VertexId w = edges_.target(h);
                const double via = so_far + length(h);
                if (via >= distance_[w] || via > 0.5 * longest_) return;
                if (distance_[w] == kFar) near_.push_back(w);
                distance_[w] = via;
                towards_[w] = h;
                open.emplace(via, w);
            });
        }
    }

    bool is_near(VertexId v) const { return distance_[v] < kFar; }

    // The part of the mesh within reach hangs together; with an Euler characteristic of 1 or more every loop in it
    // bounds.
    bool is_disc_like() const {
        std::int64_t ends = 0;     // of edges
        std::int64_t corners = 0;  // of triangles
        for (const VertexId v : near_)
            edges_.for_each_leaving(v, [&](HalfEdge h) {
                if (!is_near(edges_.target(h))) return;
                ++ends;
                if (is_near(edges_.opposite(h))) ++corners;
            });
        return static_cast<std::int64_t>(near_.size()) - ends / 2 + corners / 3 >= 1;
    }

    void collect(VertexId v, std::vector<Loop>& loops) const {
        for (const VertexId a : near_)
            edges_.for_each_leaving(a, [&](HalfEdge h) {
                const VertexId b = edges_.target(h);
                if (b < a || !is_near(b) || towards_[b] == h || towards_[a] == edges_.twin(h)) return;
                const double total = distance_[a] + length(h) + distance_[b];
                if (total >= longest_) return;
                Loop loop = close(h, total);
                if (meets_itself_only_at(v, loop)) loops.push_back(std::move(loop));
            });
        std::sort(loops.begin(), loops.end(), [](const Loop& a, const Loop& b) {
            return std::pair(a.length, a.halves.front()) < std::pair(b.length, b.halves.front());
        });
    }

    // From the root to the half-edge's origin, along it, and back from its target.
    Loop close(HalfEdge h, double total) const {
        Loop loop{total, {}};
        for (HalfEdge up = towards_[edges_.origin(h)]; up != kNoHalfEdge; up = towards_[edges_.origin(up)])
            loop.halves.push_back(up);
        std::reverse(loop.halves.begin(), loop.halves.end());
        loop.halves.push_back(h);
        for (HalfEdge up = towards_[edges_.target(h)]; up != kNoHalfEdge; up = towards_[edges_.origin(up)])
            loop.halves.push_back(edges_.twin(up));
        return loop;
    }

    bool meets_itself_only_at(VertexId v, const Loop& loop) const {
        std::vector<VertexId> visited;
        for (const HalfEdge h : loop.halves) visited.push_back(edges_.origin(h));
        std::sort(visited.begin(), visited.end());
        return visited.size() >= 3 && std::binary_search(visited.begin(), visited.end(), v) &&
               std::adjacent_find(visited.begin(), visited.end()) == visited.end();
    }

    const Mesh& mesh_;
    const HalfEdges& edges_;
    double longest_;
    std::vector<double> distance_;   // from the vertex of the search
    std::vector<HalfEdge> towards_;  // the last half-edge on the way there
    std::vector<VertexId> near_;
};

// Loops that can be cut along together: apart from each other, and what is left still hangs together as before.
class LoopChoice {
public:
    explicit LoopChoice(const HalfEdges& edges)
        : edges_(edges),
          is_cut_(edges.half_edge_slots()),
          is_taken_(edges.vertex_slots()),
          seen_(edges.half_edge_slots() / 3, 0) {}

    // Whether the two sides of a loop hang together without crossing it or one that was accepted before.
    bool joins_its_sides(const Loop& loop) {
        mark(loop, true);
        const bool joined = sides_meet(loop.halves.front());
        mark(loop, false);
        return joined;
    }

    bool accept(const Loop& loop) {
        if (is_in_the_way(loop) || has_chord(loop) || !joins_its_sides(loop)) return false;
        mark(loop, true);
        for (const HalfEdge h : loop.halves)
            edges_.for_each_leaving(edges_.origin(h), [this](HalfEdge out) {
                is_taken_[edges_.origin(out)] = true;
                is_taken_[edges_.target(out)] = true;
            });
        return true;
    }

private:
    void mark(const Loop& loop, bool cut) {
        for (const HalfEdge h : loop.halves) is_cut_[h] = is_cut_[edges_.twin(h)] = cut;
    }

    bool is_in_the_way(const Loop& loop) const {
        return std::any_of(loop.halves.begin(), loop.halves.end(),
                           [this](HalfEdge h) { return is_taken_[edges_.origin(h)]; });
    }

    bool has_chord(const Loop& loop) const {
        const std::size_t n = loop.halves.size();
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 2; j < n; ++j)
                if (j + 1 - i != n &&
                    edges_.are_neighbours(edges_.origin(loop.halves[i]), edges_.origin(loop.halves[j])))
                    return true;
        return false;
    }

    // Both sides grow in turns, so that the smaller one of two that are apart decides what it costs.
    bool sides_meet(HalfEdge h) {
        const std::uint32_t marks[2]{++last_mark_, ++last_mark_};
        std::vector<HalfEdge> triangles[2]{{h - h % 3}, {edges_.twin(h) - edges_.twin(h) % 3}};
        for (int side : {0, 1}) seen_[triangles[side].front() / 3] = marks[side];
        for (std::size_t i = 0;; ++i)
            for (int side : {0, 1}) {
                if (i == triangles[side].size()) return false;
                for (HalfEdge k = triangles[side][i]; k < triangles[side][i] + 3; ++k) {
                    if (is_cut_[k]) continue;
                    const HalfEdge beyond = edges_.twin(k) / 3;
                    if (seen_[beyond] == marks[1 - side]) return true;
                    if (seen_[beyond] == marks[side]) continue;
                    seen_[beyond] = marks[side];
                    triangles[side].push_back(3 * beyond);
                }
            }
    }

    const HalfEdges& edges_;
    std::vector<bool> is_cut_;         // per half-edge
    std::vector<bool> is_taken_;       // per vertex: on an accepted loop or next to one
    std::vector<std::uint32_t> seen_;  // per triangle
    std::uint32_t last_mark_ = 0;
};

// Cuts a mesh along loops and caps the ends.
class Cutter {
public:
    Cutter(const Mesh& mesh, const HalfEdges& edges, const SurfaceProjector& project)
        : edges_(edges), project_(project) {
        mesh_.vertices = mesh.vertices;
        mesh_.triangles = mesh.triangles;
    }

    // Both ends of the handle get vertices of their own; the first end keeps the numbers of the loop. Returns false,
    // and changes nothing, where an end has no room to be drawn back.
    bool cut(const Loop& loop) {
        const std::size_t n = loop.halves.size();
        std::vector<Side> left(n);
        std::vector<Side> right(n);
        for (std::size_t i = 0; i < n; ++i) {
            const HalfEdge out = loop.halves[i];
            const HalfEdge back = edges_.twin(loop.halves[(i + n - 1) % n]);
            left[i] = side_between(out, back);
            right[i] = side_between(back, out);
            if (left[i].inner == 0 || right[i].inner == 0) return false;
        }
        std::vector<VertexId> first(n);
        std::vector<VertexId> second(n);
        for (std::size_t i = 0; i < n; ++i) {
            first[i] = edges_.origin(loop.halves[i]);
            second[i] = static_cast<VertexId>(mesh_.vertices.size());
            mesh_.vertices.push_back(drawn_back(first[i], right[i]));
            for (const HalfEdge h : right[i].leaving) mesh_.triangles[h / 3][h % 3] = second[i];
        }
        for (std::size_t i = 0; i < n; ++i) mesh_.vertices[first[i]] = drawn_back(first[i], left[i]);
        cap(second);
        std::reverse(first.begin(), first.end());
        cap(first);
        return true;
    }

    Mesh take() { return std::move(mesh_); }

private:
    // What lies on one side of a loop at one of its vertices.
    struct Side {
        std::vector<HalfEdge> leaving;  // one per triangle
        std::size_t inner = 0;          // neighbours that are not on the loop
        Vec3 sum;                       // of their positions
    };

    // Counter-clockwise from one half-edge that leaves a vertex to another.
    Side side_between(HalfEdge from, HalfEdge to) const {
        Side side;
        for (HalfEdge h = from; h != to; h = edges_.twin(previous(h))) {
            side.leaving.push_back(h);
            if (h == from) continue;
            ++side.inner;
            side.sum += mesh_.vertices[edges_.target(h)];
        }
        return side;
    }

    Vec3 drawn_back(VertexId v, const Side& side) const {
        const Vec3 middle = (1.0 / static_cast<double>(side.inner)) * side.sum;
        SurfacePoint point;
        point.position = mesh_.vertices[v] + kDrawnBack * (middle - mesh_.vertices[v]);
        project_({&point, 1});
        return point.position;
    }

    // Fills a ring of vertices, counter-clockwise, by cutting off the corner that makes the best triangle.
    void cap(std::vector<VertexId> ring) {
        while (ring.size() > 3) {
            std::size_t best = 0;
            double least = std::numeric_limits<double>::infinity();
            for (std::size_t i = 0; i < ring.size(); ++i) {
                const Triangle t = corner(ring, i);
                const double badness =
                    cosine_of_smallest_angle(mesh_.vertices[t[0]], mesh_.vertices[t[1]], mesh_.vertices[t[2]]);
                if (badness < least) {
                    least = badness;
                    best = i;
                }
            }
            mesh_.triangles.push_back(corner(ring, best));
            ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
        }
        mesh_.triangles.push_back({ring[0], ring[1], ring[2]});
    }

    static Triangle corner(const std::vector<VertexId>& ring, std::size_t i) {
        const std::size_t n = ring.size();
        return {ring[(i + n - 1) % n], ring[i], ring[(i + 1) % n]};
    }

    const HalfEdges& edges_;
    const SurfaceProjector& project_;
    Mesh mesh_;
};

// Loops near to each other in a mesh, shortest first, at most one per handle.
std::vector<Loop> narrow_loops(const Mesh& mesh, const HalfEdges& edges, double longest) {
    LoopSearch search(mesh, edges, longest);
    LoopChoice choice(edges);
    std::vector<Loop> candidates;
    for (VertexId v = 0; v < edges.vertex_slots(); ++v) {
        if (!edges.has_vertex(v)) continue;
        std::vector<Loop> loops = search.through(v);
        const auto found = std::find_if(loops.begin(), loops.end(),
                                        [&choice](const Loop& loop) { return choice.joins_its_sides(loop); });
        if (found != loops.end()) candidates.push_back(std::move(*found));
    }
    std::stable_sort(candidates.begin(), candidates.end(),
                     [](const Loop& a, const Loop& b) { return a.length < b.length; });
    std::erase_if(candidates, [&choice](const Loop& loop) { return !choice.accept(loop); });
    return candidates;
}

// Places that are not near any of those before.
std::vector<Vec3> new_places(const Mesh& before, const Mesh& after, double reach) {
    std::vector<Vec3> found = places_of_self_intersections(after);
    if (found.empty()) return found;
    const std::vector<Vec3> old = places_of_self_intersections(before);
    std::erase_if(found, [&](const Vec3& place) {
        return std::any_of(old.begin(), old.end(),
                           [&](const Vec3& other) { return squared_norm(place - other) < reach * reach; });
    });
    return found;
}

// The loop that has a vertex nearest to a place.
std::size_t nearest_loop(const Vec3& place, const Mesh& mesh, const HalfEdges& edges, const std::vector<Loop>& loops) {
    std::pair<double, std::size_t> nearest{std::numeric_limits<double>::infinity(), 0};
    for (std::size_t i = 0; i < loops.size(); ++i)
        for (const HalfEdge h : loops[i].halves)
            nearest = std::min(nearest, {squared_norm(mesh.vertices[edges.origin(h)] - place), i});
    return nearest.second;
}

// Cuts along as many loops as can be without the mesh passing through itself.
CutMesh cut_once(const Mesh& mesh, double edge, const SurfaceProjector& project) {
    const HalfEdges edges(mesh.vertices.size(), mesh.triangles);
    std::vector<Loop> loops = narrow_loops(mesh, edges, std::numbers::pi * edge);
    while (!loops.empty()) {
        Cutter cutter(mesh, edges, project);
        CutMesh result;
        for (const Loop& loop : loops) result.handles += cutter.cut(loop) ? 1 : 0;
        result.mesh = cutter.take();
        const std::vector<Vec3> places = new_places(mesh, result.mesh, 0.5 * edge);
        if (places.empty()) return result;
        std::vector<bool> refused(loops.size());
        for (const Vec3& place : places) refused[nearest_loop(place, mesh, edges, loops)] = true;
        std::vector<Loop> left;
        for (std::size_t i = 0; i < loops.size(); ++i)
            if (!refused[i]) left.push_back(std::move(loops[i]));
        loops = std::move(left);
    }
    return {mesh, 0};
}

}  // namespace

CutMesh cut_narrow_handles(const Mesh& mesh, double edge, const SurfaceProjector& project) {
    CutMesh result{mesh, 0};
    for (;;) {
        CutMesh next = cut_once(result.mesh, edge, project);
        if (next.handles == 0) return result;
        next.handles += result.handles;
        result = std::move(next);
    }
}

}  // namespace meniscus
