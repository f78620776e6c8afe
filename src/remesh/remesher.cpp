// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/remesher.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <sstream>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "core/group_by.h"
#include "core/parallel.h"
#include "core/parallel_list.h"
#include "meniscus/errors.h"
#include "remesh/mend_slivers.h"
#include "remesh/ridges.h"
#include "remesh/self_intersections.h"
#include "remesh/working_mesh.h"
#include "space/box_tree.h"
#include "space/triangle_tree.h"

namespace meniscus {
namespace {

constexpr std::size_t kProjectedAtOnce = 512;  // vertices projected at once
constexpr std::size_t kHalfEdges = 8192;       // looked at by one task
constexpr double kCell = 6.0;                  // Å: vertices of such a cell come together
constexpr double kMostCells = 2e6;             // along an edge of the box; 21 bits

// Edges shorter than this part of the target length are collapsed (Botsch & Kobbelt 2004).
constexpr double kShort = 4.0 / 5.0;
constexpr int kIterations = 6;

// Afterwards the ends of edges shorter than this part are pushed apart so many times.
constexpr double kPushed = 0.8;
constexpr int kPushes = 4;

// Splitting and collapsing aim at this part of the given length, so that triangles lie near enough to the surface.
constexpr double kAim = 0.85;

// Adaptive lengths follow the square root of the radius of curvature, which keeps the distance of the triangles from
// the surface the same everywhere; a probe's or an atom's radius is where the length is the one asked for.
constexpr double kUsualRadius = 1.5;  // Å
constexpr double kLeastPart = 0.5;
constexpr double kLargestPart = 2.0;

// Where changes made the mesh pass through itself they are undone, and nothing so near is changed in the next attempt.
constexpr double kFrozen = 0.7;  // target lengths, times the number of attempts
constexpr int kAttempts = 4;

// Where the surface turns so fast that the middles of edges are projected anywhere, the mesh crumples: there are more
// bad triangles, or such that pass through others, in a cube of four edges. Elsewhere there are some ten. What is left
// unchanged in later attempts is smaller than the rest, and angles are small all round it.
constexpr std::size_t kMostInCube = 40;

// Where the surface has folds narrower than an edge all over, mending would take minutes and leave a mesh of the grid's
// small triangles. Such a mesh is refused: where more than 300 triangles and one in 30 are crumpled, where 1000 tries
// and one per 100 triangles have not been enough (a mesh of 173,000 triangles that is just possible takes 760 tries),
// or where so much is left as the grid has it that a later attempt has twice the triangles of the first, and 20,000
// more.
constexpr std::size_t kMayCrumple = 300;
constexpr std::size_t kOneCrumpledIn = 30;
constexpr std::size_t kHardTries = 1000;
constexpr std::size_t kOneTryPer = 100;  // triangles
constexpr std::size_t kMayGrow = 2;
constexpr std::size_t kMayAdd = 20'000;  // triangles

// Nothing is put in so near to where ridges would lead through something, Å, times the number of the try.
constexpr double kWithoutRidges = 0.1;
constexpr int kInsertions = 8;

// Ridges are let go so near to what cannot be mended beside them, in target lengths, times the number of the try.
constexpr double kLetGo = 0.8;
constexpr int kLettingGo = 3;

// Triangles with smaller angles are mended with all that lies round them (see SliverOptions), degrees. Beside ridges,
// which stay where they are, there is little room for that; where too little they are let go.
struct WantedAngles {
    double needed;
    double smallest;
    double mended;
};
constexpr WantedAngles kWanted{25.0, 30.0, 31.0};
constexpr WantedAngles kWantedBesideRidges{5.0, 12.0, 14.0};
constexpr WantedAngles kWantedWithoutRidges{20.0, 20.0, 21.0};
constexpr double kLongest = 2.2;  // of the target lengths

class Remesher {
public:
    Remesher(const Mesh& mesh, const RemeshOptions& options, const SurfaceProjector& project)
        : options_(options), project_(project), aim_(kAim * options.edge), mesh_(mesh, aim_) {
        std::vector<VertexId> all(mesh_.points.size());
        std::iota(all.begin(), all.end(), VertexId{0});
        project_points(mesh_.points, all);
    }

    // The mesh passes through itself nowhere but where it did before. Places where it would are mended; if that fails
    // all is done again without them.
    Mesh run() {
        const WorkingMesh before = mesh_;
        // Short edges round a narrow handle tell how narrow it is.
        const int pushes = options_.simplify_topology ? 0 : kPushes;
        std::size_t most_triangles = 0;
        std::vector<Vec3> places;
        for (int i = 1;; ++i) {
            freeze({places, kFrozen * (i - 1) * aim_});
            if (options_.keep_ridges && i < kAttempts) keep_ridges(before);
            for (int k = 0; k < kIterations; ++k) {
                iterate();
                if (k == 0) mesh_ = mesh_.renumbered(vertices_by_cells());  // most of the changes are made
            }
            for (int k = 0; k < pushes; ++k) push_apart();
            const std::vector<VertexId> order = vertices_by_cells();
            Mesh mesh = mesh_of(mesh_, order);
            if (i == 1) most_triangles = kMayGrow * mesh.triangles.size() + kMayAdd;
            if (mesh.triangles.size() > most_triangles) refuse(mesh.triangles.size());
            const std::vector<Vec3> found = mend(mesh, order, before, i);
            if (found.empty()) return mesh;
            places.insert(places.end(), found.begin(), found.end());
            mesh_ = before;
        }
    }

private:
    // Where a mesh passes through itself and that of the grid did not.
    std::vector<Vec3> new_crossings(const Mesh& mesh, const WorkingMesh& before) {
        std::vector<Vec3> found = places_of_self_intersections(mesh);
        if (found.empty()) return found;
        const std::vector<Vec3> old_places = places_of_self_intersections(part_near(before, found, aim_));
        const Surroundings old{old_places, aim_};
        std::erase_if(found, [&](const Vec3& place) { return old.contain(place); });
        return found;
    }

    // The triangles that come within a reach of some places, and maybe more.
    static Mesh part_near(const WorkingMesh& working, std::span<const Vec3> places, double reach) {
        std::vector<Box> boxes;
        boxes.reserve(places.size());
        for (const Vec3& place : places) boxes.push_back(Box{place, place}.grown(reach));
        const BoxTree near(boxes);
        Mesh part = mesh_of(working, working.edges.vertices());
        std::erase_if(part.triangles, [&](const Triangle& t) {
            bool overlaps = false;
            near.for_each_overlapping(box_of(part, t), [&](std::uint32_t) { overlaps = true; });
            return !overlaps;
        });
        return part;
    }

    void freeze(const Surroundings& surroundings) {
        for (std::size_t v = 0; v < mesh_.points.size(); ++v)
            if (surroundings.contain(mesh_.points[v].position)) mesh_.holds[v] = Hold::Frozen;
    }

    // Puts in the ridges but those that make the mesh pass through itself.
    void keep_ridges(const WorkingMesh& before) {
        const WorkingMesh without = mesh_;
        std::vector<Vec3> places;
        for (int i = 1;; ++i) {
            insert_ridges(mesh_, project_, {places, kWithoutRidges * i});
            const std::vector<Vec3> found = new_crossings(mesh_of(mesh_, mesh_.edges.vertices()), before);
            if (found.empty()) return;
            mesh_ = without;
            if (i == kInsertions) return;
            places.insert(places.end(), found.begin(), found.end());
        }
    }

    void iterate() {
        if (options_.adaptive) adapt();
        collapse_short();
        split_long();
        flip_towards_six();
        relax();
    }

    bool is_present(VertexId v) const { return mesh_.edges.has_vertex(v); }
    bool is_free(VertexId v) const { return is_present(v) && mesh_.holds[v] == Hold::Free; }

    void adapt() {
        for (std::size_t v = 0; v < mesh_.points.size(); ++v) {
            const double part = 1.0 / std::sqrt(std::max(kUsualRadius * mesh_.points[v].curvature, 1e-6));
            mesh_.targets[v] = aim_ * std::clamp(part, kLeastPart, kLargestPart);
        }
    }

    void collapse_short() {
        mesh_.for_each_edge([&](HalfEdge h) {
            const double length = kShort * mesh_.target(mesh_.edges.origin(h), mesh_.edges.target(h));
            if (mesh_.squared_length(h) < length * length) mesh_.collapse(h, 1.0);
        });
    }

    // Longest first: halving the short sides of flat triangles would never end.
    void split_long() {
        const std::size_t known = mesh_.points.size();
        std::vector<SplitRidge> ridges;
        for (std::vector<LongEdge> found = long_edges(); !found.empty();) {
            const std::size_t before = mesh_.points.size();
            for (const LongEdge& edge : found)
                if (mesh_.squared_length(edge.half) == edge.squared_length) split(edge.half, ridges);
            found = long_edges_round(before);
        }
        std::vector<VertexId> added(mesh_.points.size() - known);
        std::iota(added.begin(), added.end(), static_cast<VertexId>(known));
        group_by_place(added);
        parallel_for(ridges.size(), 1, [&](std::size_t i) {
            ridges[i].place = point_on_ridge(mesh_.at(ridges[i].vertex), ridges[i].corners, project_);
        });
        for (const SplitRidge& ridge : ridges)
            if (ridge.place) mesh_.points[ridge.vertex].position = *ridge.place;
        project_points(mesh_.points, added);
    }

    struct SplitRidge {
        VertexId vertex;
        std::array<Vec3, 2> corners;  // of the triangles of the edge
        std::optional<Vec3> place;
    };

    void split(HalfEdge h, std::vector<SplitRidge>& ridges) {
        const std::array<Vec3, 2> corners{mesh_.at(mesh_.edges.opposite(h)),
                                          mesh_.at(mesh_.edges.opposite(mesh_.edges.twin(h)))};
        const VertexId v = mesh_.split(h);
        if (mesh_.holds[v] == Hold::Ridge) ridges.push_back({v, corners, std::nullopt});
    }

    struct LongEdge {
        double squared_length;
        HalfEdge half;
    };

    std::vector<LongEdge> long_edges() const {
        const auto list_long = [&](std::size_t begin, std::size_t end, std::vector<LongEdge>& list) {
            for (auto h = static_cast<HalfEdge>(begin); h < end; ++h)
                if (mesh_.edges.has(h) && h < mesh_.edges.twin(h) && is_long(h))
                    list.push_back({mesh_.squared_length(h), h});
        };
        std::vector<LongEdge> found = parallel_list<LongEdge>(mesh_.edges.half_edge_slots(), kHalfEdges, list_long);
        sort_longest_first(found);
        return found;
    }

    // Lists those of triangles round the vertices from `first` on: splitting has left long edges nowhere else.
    std::vector<LongEdge> long_edges_round(std::size_t first) const {
        const HalfEdges& edges = mesh_.edges;
        std::vector<LongEdge> found;
        const auto look_at = [&](HalfEdge h) {
            if (is_long(h)) found.push_back({mesh_.squared_length(h), std::min(h, edges.twin(h))});
        };
        for (auto v = static_cast<VertexId>(first); v < mesh_.points.size(); ++v)
            edges.for_each_leaving(v, [&](HalfEdge h) {
                look_at(h);
                look_at(next(h));
            });
        sort_longest_first(found);
        const auto same = [](const LongEdge& a, const LongEdge& b) { return a.half == b.half; };
        found.erase(std::unique(found.begin(), found.end(), same), found.end());
        return found;
    }

    static void sort_longest_first(std::vector<LongEdge>& edges) {
        std::sort(edges.begin(), edges.end(), [](const LongEdge& a, const LongEdge& b) {
            return std::pair(-a.squared_length, a.half) < std::pair(-b.squared_length, b.half);
        });
    }

    bool is_long(HalfEdge h) const {
        const VertexId a = mesh_.edges.origin(h);
        const VertexId b = mesh_.edges.target(h);
        const double length = kLongEdge * mesh_.target(a, b);
        return mesh_.squared_length(h) > length * length && mesh_.holds[a] != Hold::Frozen &&
               mesh_.holds[b] != Hold::Frozen;
    }

    void flip_towards_six() {
        const HalfEdges& edges = mesh_.edges;
        std::vector<int> valences(edges.vertex_slots());
        for (HalfEdge h = 0; h < edges.half_edge_slots(); ++h)
            if (edges.has(h)) ++valences[edges.origin(h)];
        const auto off = [&](VertexId v, int change) { return std::abs(valences[v] + change - 6); };
        mesh_.for_each_edge([&](HalfEdge h) {
            const VertexId a = edges.origin(h);
            const VertexId b = edges.target(h);
            const VertexId c = edges.opposite(h);
            const VertexId d = edges.opposite(edges.twin(h));
            const int before = off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
            const int after = off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1);
            if (after >= before || !mesh_.try_flip(h, WorkingMesh::Facing::Out).allowed) return;
            mesh_.edges.flip(h);
            --valences[a];
            --valences[b];
            ++valences[c];
            ++valences[d];
        });
    }

    // Every free vertex moves to the middle of its neighbours, along the surface. What turns triangles over is undone.
    void relax() {
        std::vector<SurfacePoint> moved = mesh_.points;
        std::vector<VertexId> free;
        for (VertexId v = 0; v < moved.size(); ++v)
            if (is_free(v)) free.push_back(v);
        group_by_place(free);
        for_chunks(free, [&](std::span<const VertexId> chunk) {
            for (const VertexId v : chunk) moved[v].position = relaxed(v);
            project_chunk(moved, chunk);
        });
        std::swap(mesh_.points, moved);
        undo_where_turned(moved);
    }

    // The ends of edges that are still short move away from each other, along the surface.
    void push_apart() {
        std::vector<Vec3> steps(mesh_.points.size());
        parallel_for(steps.size(), kProjectedAtOnce, [&](std::size_t v) {
            if (is_free(static_cast<VertexId>(v))) steps[v] = push(static_cast<VertexId>(v));
        });
        std::vector<SurfacePoint> moved = mesh_.points;
        std::vector<VertexId> pushed;
        for (VertexId v = 0; v < steps.size(); ++v) {
            if (steps[v] == Vec3{}) continue;
            moved[v].position += steps[v];
            pushed.push_back(v);
        }
        group_by_place(pushed);
        project_points(moved, pushed);
        std::swap(mesh_.points, moved);
        undo_where_turned(moved);
    }

    Vec3 push(VertexId v) const {
        Vec3 sum;
        mesh_.edges.for_each_leaving(v, [&](HalfEdge h) {
            const double length = kPushed * mesh_.target(v, mesh_.edges.target(h));
            const double squared = mesh_.squared_length(h);
            if (squared < length * length && squared > 0.0)
                sum += (0.5 * (1.0 - length / std::sqrt(squared))) * (mesh_.at(mesh_.edges.target(h)) - mesh_.at(v));
        });
        const Vec3& normal = mesh_.points[v].normal;
        return sum - dot(sum, normal) * normal;
    }

    Vec3 relaxed(VertexId v) const {
        Vec3 sum;
        double count = 0.0;
        mesh_.edges.for_each_leaving(v, [&](HalfEdge h) {
            sum += mesh_.at(mesh_.edges.target(h));
            count += 1.0;
        });
        const SurfacePoint& p = mesh_.points[v];
        const Vec3 step = (1.0 / count) * sum - p.position;
        return p.position + step - dot(step, p.normal) * p.normal;
    }

    void undo_where_turned(const std::vector<SurfacePoint>& before) {
        const HalfEdges& edges = mesh_.edges;
        std::vector<std::uint8_t> in_doubt(edges.half_edge_slots() / 3);  // per triangle
        parallel_for(in_doubt.size(), kProjectedAtOnce, [&](std::size_t t) {
            const auto h = static_cast<HalfEdge>(3 * t);
            in_doubt[t] = edges.has(h) && !faces_out(h) ? 1 : 0;
        });
        for (bool again = true; again;) {
            again = false;
            for (std::size_t t = 0; t < in_doubt.size(); ++t) {
                if (in_doubt[t] == 0) continue;
                in_doubt[t] = 0;
                const auto h = static_cast<HalfEdge>(3 * t);
                if (faces_out(h)) continue;
                for (const VertexId v : {edges.origin(h), edges.target(h), edges.opposite(h)}) {
                    if (mesh_.at(v) == before[v].position) continue;
                    mesh_.points[v] = before[v];
                    edges.for_each_leaving(v, [&](HalfEdge out) { in_doubt[out / 3] = 1; });
                    again = true;
                }
            }
        }
    }

    bool faces_out(HalfEdge h) const {
        return mesh_.faces_out(mesh_.edges.origin(h), mesh_.edges.target(h), mesh_.edges.opposite(h));
    }

    // Puts neighbours in space next to each other: new vertices come in no such order.
    void group_by_place(std::vector<VertexId>& vertices) const {
        Box box;
        for (const VertexId v : vertices) box.include(mesh_.at(v));
        std::vector<std::uint64_t> cells;
        cells.reserve(vertices.size());
        for (const VertexId v : vertices) {
            const Vec3 place = (1.0 / kCell) * (mesh_.at(v) - box.low);
            const auto number = [](double x) { return static_cast<std::uint64_t>(std::min(x, kMostCells)); };
            cells.push_back((number(place.z) << 42) + (number(place.y) << 21) + number(place.x));
        }
        std::vector<VertexId> together;
        together.reserve(vertices.size());
        for (const std::uint32_t i : group_by<std::hash<std::uint64_t>>(cells).items) together.push_back(vertices[i]);
        vertices = std::move(together);
    }

    std::vector<VertexId> vertices_by_cells() const {
        std::vector<VertexId> vertices = mesh_.edges.vertices();
        group_by_place(vertices);
        return vertices;
    }

    template <class Body>
    static void for_chunks(std::span<const VertexId> vertices, const Body& body) {
        parallel_chunks(vertices.size(), kProjectedAtOnce,
                        [&](std::size_t begin, std::size_t end) { body(vertices.subspan(begin, end - begin)); });
    }

    void project_points(std::vector<SurfacePoint>& points, std::span<const VertexId> vertices) const {
        for_chunks(vertices, [&](std::span<const VertexId> chunk) { project_chunk(points, chunk); });
    }

    void project_chunk(std::vector<SurfacePoint>& points, std::span<const VertexId> vertices) const {
        std::vector<SurfacePoint> moving;
        moving.reserve(vertices.size());
        for (const VertexId v : vertices) moving.push_back(points[v]);
        project_(moving);
        for (std::size_t i = 0; i < moving.size(); ++i) points[vertices[i]] = moving[i];
    }

    // Mends small angles and crossings, each with its neighbourhood. Returns where the next attempt has to do without
    // changes: where the mesh still passes through itself, or is crumpled. That would take longer to mend than all the
    // other attempts.
    std::vector<Vec3> mend(Mesh& mesh, std::span<const VertexId> order, const WorkingMesh& before, int attempt) {
        SliverOptions slivers = sliver_options(mesh.triangles.size(), attempt);
        for (const VertexId v : order) {
            mesh.normals.push_back(to_small(mesh_.points[v].normal));
            slivers.held.push_back(mesh_.holds[v] == Hold::Ridge);
        }
        MeshChanges changes = mend_slivers(mesh, slivers, project_);
        std::vector<Vec3> crumpled = std::move(changes.crumpled);
        if (changes.gave_up || crumpled.size() > slivers.most_crumpled) refuse(mesh.triangles.size());
        was_crumpled_ = was_crumpled_ || !crumpled.empty();
        const bool was_tangled = changes.was_tangled;
        want(kWantedWithoutRidges, slivers);
        slivers.most_bad = slivers.most_tangled = SliverOptions{}.most_bad;
        for (int i = 1; options_.keep_ridges && crumpled.empty() && i <= kLettingGo; ++i) {
            renumber_entries(changes, slivers.held);
            const std::vector<Vec3> places = bad_places(mesh, before);
            if (!let_go(mesh, {places, kLetGo * i * aim_}, slivers.held)) break;
            changes = mend_slivers(mesh, slivers, project_);
        }
        mesh.normals.clear();
        if (attempt == kAttempts || !was_tangled) return crumpled;
        const std::vector<Vec3> crossings = new_crossings(mesh, before);
        return crossings.empty() ? crumpled : crossings;
    }

    SliverOptions sliver_options(std::size_t triangles, int attempt) const {
        SliverOptions slivers{.edge = options_.edge,
                              .longest_edge = kLongest * *std::max_element(mesh_.targets.begin(), mesh_.targets.end()),
                              .search_everywhere = true};
        if (attempt == 1) slivers.most_bad = kMostInCube;
        if (attempt < kAttempts) slivers.most_tangled = kMostInCube;
        slivers.most_crumpled = kMayCrumple + triangles / kOneCrumpledIn;
        slivers.most_hard_tries = kHardTries + triangles / kOneTryPer;
        want(options_.keep_ridges || was_crumpled_ ? kWantedBesideRidges : kWanted, slivers);
        return slivers;
    }

    [[noreturn]] void refuse(std::size_t triangles) const {
        std::ostringstream message;
        message << "edge " << options_.edge << ": the surface has folds narrower than that all over, and too many of "
                << triangles
                << " triangles would be crumpled; choose a smaller edge, or leave it out for the triangles of "
                << "the grid";
        throw UsageError(message.str());
    }

    static void want(const WantedAngles& angles, SliverOptions& slivers) {
        slivers.needed_angle_deg = angles.needed;
        slivers.smallest_angle_deg = angles.smallest;
        slivers.mended_angle_deg = angles.mended;
    }

    // Where a mesh has small angles or passes through itself.
    std::vector<Vec3> bad_places(const Mesh& mesh, const WorkingMesh& before) {
        const double narrow = elementary::cos(kWantedWithoutRidges.smallest * std::numbers::pi / 180.0);
        std::vector<Vec3> places = new_crossings(mesh, before);
        for (const auto& [a, b, c] : mesh.triangles) {
            const Vec3& p = mesh.vertices[a];
            const Vec3& q = mesh.vertices[b];
            const Vec3& r = mesh.vertices[c];
            if (cosine_of_smallest_angle(p, q, r) > narrow) places.push_back((1.0 / 3.0) * (p + q + r));
        }
        return places;
    }

    // Returns whether there were ridges.
    static bool let_go(const Mesh& mesh, const Surroundings& surroundings, std::vector<bool>& held) {
        bool any = false;
        for (VertexId v = 0; v < held.size(); ++v) {
            if (!held[v] || !surroundings.contain(mesh.vertices[v])) continue;
            held[v] = false;
            any = true;
        }
        return any;
    }

    static Mesh mesh_of(const WorkingMesh& working, std::span<const VertexId> order) {
        Mesh mesh;
        mesh.triangles = working.edges.triangles(order);
        mesh.vertices.reserve(order.size());
        for (const VertexId v : order) mesh.vertices.push_back(working.at(v));
        return mesh;
    }

    const RemeshOptions& options_;
    const SurfaceProjector& project_;
    double aim_;  // length of edges, Å
    WorkingMesh mesh_;
    bool was_crumpled_ = false;  // in an attempt before: small angles are then part of it
};

}  // namespace

Mesh remesh(const Mesh& mesh, const RemeshOptions& options, const SurfaceProjector& project) {
    return Remesher(mesh, options, project).run();
}

}  // namespace meniscus
