// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/mend_slivers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <map>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "mesh/local_corners.h"
#include "remesh/first_look.h"
#include "remesh/mesh_search.h"
#include "remesh/patch.h"
#include "remesh/patch_mender.h"
#include "remesh/self_intersections.h"
#include "space/box_tree.h"
#include "space/triangle_tree.h"

namespace meniscus {
namespace {

// How far from a bad triangle vertices may move, and how far all triangles are known, in usual lengths of edges.
constexpr double kFree = 2.5;
constexpr double kRoom = 5.0;

constexpr std::size_t kPlacesTogether = 32;  // places: what is cut out of the mesh for them takes memory

constexpr double kCube = 4.0;  // see SliverOptions::most_bad

// A triangle that is still below the needed angle is mended again, with so many times the surroundings.
constexpr double kWider = 2.0;

// A bad triangle's neighbourhood: vertices in `free` may move, all triangles that reach into `room` are there.
struct Place {
    std::uint32_t triangle = 0;
    Box free;
    Box room;
};

// The part of a mesh round a place, and the numbers of its vertices and triangles in the mesh.
struct Cutting {
    MendablePatch part;
    std::vector<VertexId> vertices;
    std::vector<std::uint32_t> triangles;
};

class SliverMender {
public:
    SliverMender(Mesh& mesh, const SliverOptions& options, const SurfaceProjector& project)
        : mesh_(mesh),
          options_(options),
          project_(project),
          angles_{tangent_of_degrees(std::min(options.needed_angle_deg, options.smallest_angle_deg)),
                  tangent_of_degrees(options.smallest_angle_deg)} {}

    MeshChanges run(FirstLook::Suspects suspects) {
        std::erase_if(suspects.bad, [this](std::uint32_t t) { return !is_bad(mesh_.triangles[t]); });
        boxes_ = std::move(suspects.boxes);
        MeshChanges nothing;
        nothing.crumpled = crowded(suspects.bad, options_.most_bad);
        if (nothing.crumpled.size() <= options_.most_crumpled)
            tangled_ = options_.search_everywhere ? self_intersecting_triangles(mesh_)
                                                  : tangled_triangles(mesh_, boxes_, suspects.leaning);
        nothing.was_tangled = !tangled_.empty();
        if (nothing.crumpled.empty()) nothing.crumpled = crowded(tangled_, options_.most_tangled);
        if (!nothing.crumpled.empty()) {
            nothing.with_new = nothing.left = mesh_.vertices.size();
            return nothing;
        }
        std::vector<std::uint32_t> pending;
        std::set_union(suspects.bad.begin(), suspects.bad.end(), tangled_.begin(), tangled_.end(),
                       std::back_inserter(pending));
        drop_tiny_components(mend(mend(std::move(pending), 1.0), kWider));
        MeshChanges changes = close_holes(mesh_, std::move(changes_));
        changes.was_tangled = nothing.was_tangled;
        changes.gave_up = gave_up();
        return changes;
    }

private:
    bool gave_up() const { return hard_tries_ > options_.most_hard_tries; }

    // A corner of each of those triangles of which there are more than `most` in a cube.
    std::vector<Vec3> crowded(const std::vector<std::uint32_t>& triangles, std::size_t most) const {
        if (triangles.size() <= most) return {};
        std::map<std::array<std::int64_t, 3>, std::vector<Vec3>> cubes;
        const auto number = [this](double x) { return std::llround(std::floor(x / (kCube * options_.edge))); };
        for (const std::uint32_t t : triangles) {
            const Vec3& corner = mesh_.vertices[mesh_.triangles[t][0]];
            cubes[{number(corner.z), number(corner.y), number(corner.x)}].push_back(corner);
        }
        std::vector<Vec3> places;
        for (const auto& [cube, corners] : cubes)
            if (corners.size() > most) places.insert(places.end(), corners.begin(), corners.end());
        return places;
    }

    double goodness(const Triangle& triangle) const {
        return goodness_of(point(triangle[0]), point(triangle[1]), point(triangle[2]), options_.shortest_edge());
    }
    bool is_bad(const Triangle& triangle) const { return goodness(triangle) < angles_.wanted; }
    bool is_tangled(std::uint32_t triangle) const {
        return std::binary_search(tangled_.begin(), tangled_.end(), triangle);
    }
    SurfacePoint point(VertexId v) const { return {mesh_.vertices[v], mesh_.normals[v], 0.0}; }

    // Mends in rounds, with `reach` times the usual surroundings. Returns the triangles near mended places that are
    // below the needed angle, rising.
    std::vector<std::uint32_t> mend(std::vector<std::uint32_t> pending, double reach) {
        std::vector<std::uint32_t> low;
        while (!pending.empty() && !gave_up()) pending = mend_round(pending, reach, low);
        std::sort(low.begin(), low.end());
        low.erase(std::unique(low.begin(), low.end()), low.end());
        return low;
    }

    // Drops the tiny components of triangles that could not be mended.
    void drop_tiny_components(const std::vector<std::uint32_t>& low) {
        if (low.empty() || options_.tiny_component == 0) return;
        const MeshSearch search(mesh_, boxes_);
        for (const std::uint32_t t : low) {
            if (is_removed(mesh_.triangles[t]) || !is_bad(mesh_.triangles[t])) continue;
            const std::vector<std::uint32_t> component = tiny_component_of(t, search);
            if (component.empty() || component.size() + changes_.removed.size() == mesh_.triangles.size()) continue;
            std::vector<VertexId> corners;
            for (const std::uint32_t number : component) {
                Triangle& triangle = mesh_.triangles[number];
                corners.insert(corners.end(), triangle.begin(), triangle.end());
                triangle = {};
                changes_.removed.push_back(number);
            }
            const std::vector<VertexId> vertices = LocalCorners(std::move(corners)).vertices();
            changes_.holes.insert(changes_.holes.end(), vertices.begin(), vertices.end());
            changes_.dropped_components = true;
        }
    }

    // The triangles of the component of one if it is tiny, else nothing. On a sphere there are four less than twice as
    // many triangles as vertices, and on a part of one still fewer.
    std::vector<std::uint32_t> tiny_component_of(std::uint32_t triangle, const MeshSearch& search) const {
        const std::size_t most = options_.tiny_component;
        std::vector<std::uint32_t> found{triangle};
        std::vector<VertexId> corners(mesh_.triangles[triangle].begin(), mesh_.triangles[triangle].end());
        for (std::size_t i = 0; i < found.size() && found.size() <= most; ++i)
            search.for_each_near(box_of(mesh_, mesh_.triangles[found[i]]), [&](std::uint32_t t, const Box&) {
                const auto is_corner = [&](VertexId v) {
                    return std::find(corners.begin(), corners.end(), v) != corners.end();
                };
                const Triangle& near = mesh_.triangles[t];
                if (std::find(found.begin(), found.end(), t) != found.end()) return;
                if (std::none_of(near.begin(), near.end(), is_corner)) return;
                found.push_back(t);
                for (const VertexId v : mesh_.triangles[t])
                    if (!is_corner(v)) corners.push_back(v);
            });
        const bool whole = found.size() <= most && found.size() + 4 == 2 * corners.size();
        return whole ? found : std::vector<std::uint32_t>();
    }

    // Mends places far enough from each other side by side; returns the triangles that have to wait. Appends to `low`.
    std::vector<std::uint32_t> mend_round(const std::vector<std::uint32_t>& pending, double reach,
                                          std::vector<std::uint32_t>& low) {
        std::vector<std::uint32_t> waiting;
        const std::vector<Place> places = choose_places(pending, reach, waiting);
        const MeshSearch search(mesh_, boxes_);
        for (std::size_t begin = 0; begin < places.size() && !gave_up(); begin += kPlacesTogether)
            mend_places(search, std::span(places).subspan(begin, std::min(kPlacesTogether, places.size() - begin)),
                        low);
        forget_tangled(places);
        return waiting;
    }

    void mend_places(const MeshSearch& search, std::span<const Place> places, std::vector<std::uint32_t>& low) {
        std::vector<Cutting> cuttings(places.size());
        std::vector<Patch> mended(places.size());
        std::vector<std::size_t> hard_tries(places.size());
        parallel_for(places.size(), 1, [&](std::size_t i) {
            cuttings[i] = cut_out(search, places[i]);
            PatchMender mender(cuttings[i].part, options_, project_);
            mender.mend();
            if ((options_.search_everywhere || has_tangled(cuttings[i])) && mender.untangle()) mender.mend();
            mended[i] = mender.patch();
            hard_tries[i] = mender.hard_tries();
        });
        for (std::size_t i = 0; i < places.size(); ++i) {
            paste(cuttings[i], mended[i]);
            for (const std::uint32_t t : cuttings[i].triangles)
                if (!is_removed(mesh_.triangles[t]) && goodness(mesh_.triangles[t]) < angles_.needed) low.push_back(t);
            hard_tries_ += hard_tries[i];
        }
    }

    bool has_tangled(const Cutting& cutting) const {
        return std::any_of(cutting.triangles.begin(), cutting.triangles.end(),
                           [this](std::uint32_t t) { return is_tangled(t); });
    }

    // Tangled triangles of these places have had their turn, all together.
    void forget_tangled(const std::vector<Place>& places) {
        std::erase_if(tangled_, [&](std::uint32_t t) {
            return std::any_of(places.begin(), places.end(), [&](const Place& place) {
                return std::all_of(mesh_.triangles[t].begin(), mesh_.triangles[t].end(),
                                   [&](VertexId v) { return place.free.squared_distance(mesh_.vertices[v]) == 0.0; });
            });
        });
    }

    // Places whose rooms do not overlap, in the order of the triangles.
    std::vector<Place> choose_places(const std::vector<std::uint32_t>& pending, double reach,
                                     std::vector<std::uint32_t>& waiting) const {
        std::vector<Place> places;
        std::map<std::array<int, 3>, std::vector<std::size_t>> cells;  // places by the cells that their rooms touch
        const double cell = 4.0 * reach * kRoom * options_.edge;
        const auto for_each_cell = [cell](const Box& box, const auto& visit) {
            const auto number = [cell](double x) { return static_cast<int>(std::floor(x / cell)); };
            for (int z = number(box.low.z); z <= number(box.high.z); ++z)
                for (int y = number(box.low.y); y <= number(box.high.y); ++y)
                    for (int x = number(box.low.x); x <= number(box.high.x); ++x) visit(std::array<int, 3>{z, y, x});
        };
        for (const std::uint32_t t : pending) {
            const Triangle& triangle = mesh_.triangles[t];
            if (is_removed(triangle) || !(is_bad(triangle) || is_tangled(t))) continue;
            const Box box = box_of(mesh_, triangle);
            const Place place{t, box.grown(reach * kFree * options_.edge), box.grown(reach * kRoom * options_.edge)};
            bool overlaps = false;
            for_each_cell(place.room, [&](const std::array<int, 3>& at) {
                const auto found = cells.find(at);
                if (found == cells.end()) return;
                for (const std::size_t other : found->second)
                    overlaps = overlaps || places[other].room.overlaps(place.room);
            });
            if (overlaps) {
                waiting.push_back(t);
                continue;
            }
            for_each_cell(place.room, [&](const std::array<int, 3>& at) { cells[at].push_back(places.size()); });
            places.push_back(place);
        }
        return places;
    }

    Cutting cut_out(const MeshSearch& search, const Place& place) const {
        Cutting cutting;
        auto& [patch, free, held, room] = cutting.part;
        room = place.room;
        std::vector<VertexId> vertices;
        search.for_each_near(place.room, [&](std::uint32_t t, const Box&) {
            cutting.triangles.push_back(t);
            vertices.insert(vertices.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
        });
        const LocalCorners corners(std::move(vertices));
        cutting.vertices = corners.vertices();
        patch.points.reserve(cutting.vertices.size());
        std::vector<bool> sticks_out;
        for (const VertexId v : cutting.vertices) {
            const Vec3& place_of_v = mesh_.vertices[v];
            patch.points.push_back({place_of_v, mesh_.normals[v], 0.0});
            free.push_back(place.free.contains({place_of_v, place_of_v}));
            held.push_back(v < options_.held.size() && options_.held[v]);
            sticks_out.push_back(!place.room.contains({place_of_v, place_of_v}));
        }
        patch.triangles.reserve(cutting.triangles.size());
        for (const std::uint32_t number : cutting.triangles) {
            const Triangle& t = patch.triangles.emplace_back(corners.local(mesh_.triangles[number]));
            // Only vertices whose triangles lie wholly in the room are free: no other patch knows these.
            if (sticks_out[t[0]] || sticks_out[t[1]] || sticks_out[t[2]])
                for (const VertexId v : t) free[v] = false;
        }
        return cutting;
    }

    // Puts a patch back, with what it has more than before at the end of the mesh.
    void paste(Cutting& cutting, const Patch& after) {
        const Patch& before = cutting.part.patch;
        add_new(cutting, after);
        for (std::size_t v = 0; v < before.points.size(); ++v) {
            if (after.points[v].position == before.points[v].position) continue;
            mesh_.vertices[cutting.vertices[v]] = after.points[v].position;
            mesh_.normals[cutting.vertices[v]] = to_small(after.points[v].normal);
            changes_.moved.push_back(cutting.vertices[v]);
        }
        for (const std::size_t t : changed_triangles(before, after)) {
            const auto& [a, b, c] = after.triangles[t];
            const std::uint32_t number = cutting.triangles[t];
            const Triangle triangle{cutting.vertices[a], cutting.vertices[b], cutting.vertices[c]};
            mesh_.triangles[number] = triangle;
            changes_.triangles.push_back(number);
            if (is_removed(triangle))
                changes_.removed.push_back(number);
            else
                boxes_.include(mesh_, number);
        }
        std::vector<bool> in_use(after.points.size());
        for (std::size_t t = 0; t < after.triangles.size(); ++t)
            if (after.has(t))
                for (const VertexId v : after.triangles[t]) in_use[v] = true;
        for (std::size_t v = 0; v < in_use.size(); ++v)
            if (!in_use[v]) changes_.holes.push_back(cutting.vertices[v]);
    }

    void add_new(Cutting& cutting, const Patch& after) {
        const std::size_t known = cutting.vertices.size();
        for (std::size_t v = known; v < after.points.size(); ++v) {
            cutting.vertices.push_back(static_cast<VertexId>(mesh_.vertices.size()));
            mesh_.vertices.push_back(after.points[v].position);
            mesh_.normals.push_back(to_small(after.points[v].normal));
            changes_.moved.push_back(cutting.vertices.back());
        }
        for (std::size_t t = cutting.triangles.size(); t < after.triangles.size(); ++t) {
            cutting.triangles.push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
            mesh_.triangles.push_back({0, 0, 0});
            boxes_.resize(mesh_.triangles.size());
        }
        if (!mesh_.components.empty()) label_new(cutting, after, known);
    }

    // New vertices belong to the pieces of their neighbours, of which some may be new, too.
    void label_new(const Cutting& cutting, const Patch& after, std::size_t known) {
        constexpr std::uint32_t kNone = ~std::uint32_t{0};
        mesh_.components.resize(mesh_.vertices.size(), kNone);
        for (std::size_t i = known; i < cutting.vertices.size(); ++i)
            for (std::size_t t = 0; t < after.triangles.size(); ++t) {
                if (!after.has(t)) continue;
                std::uint32_t label = kNone;
                for (const VertexId v : after.triangles[t])
                    label = std::min(label, mesh_.components[cutting.vertices[v]]);
                for (const VertexId v : after.triangles[t]) mesh_.components[cutting.vertices[v]] = label;
            }
        for (std::size_t i = known; i < cutting.vertices.size(); ++i) {
            std::uint32_t& label = mesh_.components[cutting.vertices[i]];
            if (label == kNone) label = 0;  // removed again
        }
    }

    struct Tangents {
        double needed;
        double wanted;
    };

    Mesh& mesh_;
    const SliverOptions& options_;
    const SurfaceProjector& project_;
    Tangents angles_;
    TriangleBoxes boxes_;
    std::vector<std::uint32_t> tangled_;  // triangles, as they were found, that have not had their turn
    PendingChanges changes_;
    std::size_t hard_tries_ = 0;
};

}  // namespace

MeshChanges mend_slivers(Mesh& mesh, const SliverOptions& options, const SurfaceProjector& project) {
    FirstLook look(mesh, options.smallest_angle_deg, options.shortest_edge());
    look.look_at_all();
    return mend_slivers(mesh, options, project, std::move(look));
}

MeshChanges mend_slivers(Mesh& mesh, const SliverOptions& options, const SurfaceProjector& project, FirstLook look) {
    return SliverMender(mesh, options, project).run(std::move(look).suspects());
}

}  // namespace meniscus
