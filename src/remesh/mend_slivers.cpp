// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/mend_slivers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <iterator>
#include <map>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "core/bits.h"
#include "core/parallel.h"
#include "core/parallel_list.h"
#include "mesh/corner_numbers.h"
#include "mesh/local_corners.h"
#include "remesh/first_look.h"
#include "remesh/near_triangles.h"
#include "remesh/patch.h"
#include "remesh/patch_mender.h"
#include "remesh/self_intersections.h"
#include "space/box_tree.h"
#include "space/triangle_tree.h"

namespace meniscus {
namespace {

constexpr std::size_t kRenumbered = 1024;  // triangles per task

constexpr std::size_t kLeaningPerTask = 256;
constexpr double kNeighbours = 4.0;  // usual lengths of edges: triangles within a cube of these look round together

// In usual lengths of edges: how far from a bad triangle things change, and how far all is known.
constexpr double kFree = 2.5;
constexpr double kRoom = 5.0;

constexpr std::size_t kPlacesTogether = 32;  // places: what is cut out of the mesh for them takes memory

constexpr double kCube = 4.0;  // see SliverOptions::most_bad

// What that leaves below the needed angle is mended with so many times as much round it.
constexpr double kWider = 2.0;

// A bad triangle's neighbourhood: vertices in `free` may move, all triangles that reach into `room` are there.
struct Place {
    std::uint32_t triangle = 0;
    Box free;
    Box room;
};

// The part of a mesh round a place, and the mesh's numbers for it.
struct Cutting {
    Patch patch;
    std::vector<bool> free;
    std::vector<bool> held;
    std::vector<VertexId> vertices;
    std::vector<std::uint32_t> triangles;
};

// Numbers anew what some numbers have no part in any more, in their order.
void close_gaps(std::vector<std::uint32_t>& numbers) {
    std::vector<std::uint32_t> taken;
    for (const std::uint32_t n : numbers) {
        if (n >= taken.size()) taken.resize(std::size_t{n} + 1);
        taken[n] = 1;
    }
    if (std::count(taken.begin(), taken.end(), 0U) == 0) return;
    std::exclusive_scan(taken.begin(), taken.end(), taken.begin(), 0U);
    for (std::uint32_t& n : numbers) n = taken[n];
}

class SliverMender {
public:
    SliverMender(Mesh& mesh, const SliverOptions& options, const SurfaceProjector& project)
        : mesh_(mesh),
          options_(options),
          project_(project),
          needed_(tangent_of_degrees(std::min(options.needed_angle_deg, options.smallest_angle_deg))),
          wanted_(tangent_of_degrees(options.smallest_angle_deg)) {}

    MeshChanges run(FirstLook::Suspects suspects) {
        std::erase_if(suspects.bad, [this](std::uint32_t t) { return !is_bad(mesh_.triangles[t]); });
        boxes_ = std::move(suspects.boxes);
        may_be_low_.resize(mesh_.triangles.size());
        for (const std::uint32_t t : suspects.bad) may_be_low_[t] = true;
        MeshChanges nothing;
        nothing.crumpled = crowded(suspects.bad, options_.most_bad);
        if (nothing.crumpled.size() <= options_.most_crumpled)
            tangled_ = options_.search_everywhere ? self_intersecting_triangles(mesh_) : tangled_of(suspects.leaning);
        was_tangled_ = !tangled_.empty();
        if (nothing.crumpled.empty()) nothing.crumpled = crowded(tangled_, options_.most_tangled);
        if (!nothing.crumpled.empty()) {
            nothing.with_new = nothing.left = mesh_.vertices.size();
            nothing.was_tangled = was_tangled_;
            return nothing;
        }
        std::vector<std::uint32_t> pending;
        std::set_union(suspects.bad.begin(), suspects.bad.end(), tangled_.begin(), tangled_.end(),
                       std::back_inserter(pending));
        mend(std::move(pending));
        reach_ = kWider;
        mend(std::exchange(left_, {}));
        drop_crumbs();
        return close_holes();
    }

private:
    bool is_removed(const Triangle& t) const { return t[0] == t[1]; }
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
    bool is_bad(const Triangle& triangle) const { return goodness(triangle) < wanted_; }
    bool is_tangled(std::uint32_t triangle) const {
        return std::binary_search(tangled_.begin(), tangled_.end(), triangle);
    }
    SurfacePoint point(VertexId v) const { return {mesh_.vertices[v], mesh_.normals[v], 0.0}; }

    // Triangles that pass through each other, one of two at least a leaning one.
    std::vector<std::uint32_t> tangled_of(const std::vector<std::uint32_t>& leaning) const {
        if (leaning.empty()) return {};
        const BoxTree chunks(boxes_.chunks);
        auto all = parallel_list<std::uint32_t>(
            leaning.size(), kLeaningPerTask, [&](std::size_t begin, std::size_t end, auto& numbers) {
                NearTriangles near;
                while (begin < end) {
                    const std::size_t count = neighbours_among(std::span(leaning).subspan(begin, end - begin));
                    find_tangled(chunks, std::span(leaning).subspan(begin, count), near, numbers);
                    begin += count;
                }
            });
        std::sort(all.begin(), all.end());
        all.erase(std::unique(all.begin(), all.end()), all.end());
        return all;
    }

    // How many triangles from the first one on lie so near to each other that they share what is near them.
    std::size_t neighbours_among(std::span<const std::uint32_t> triangles) const {
        Box all;
        std::size_t count = 0;
        for (; count < triangles.size(); ++count) {
            all.include(box_of(mesh_, mesh_.triangles[triangles[count]]));
            const Vec3 size = all.high - all.low;
            if (std::max({size.x, size.y, size.z}) > kNeighbours * options_.edge) break;
        }
        return std::max<std::size_t>(count, 1);
    }

    // Appends those of some neighbours and of all other triangles that pass through each other. near: memory
    void find_tangled(const BoxTree& chunks, std::span<const std::uint32_t> neighbours, NearTriangles& near,
                      std::vector<std::uint32_t>& numbers) const {
        Box all;
        for (const std::uint32_t t : neighbours) all.include(box_of(mesh_, mesh_.triangles[t]));
        near.clear();
        for_each_near(chunks, all, [&](std::uint32_t t, const Box& box) { near.add(box, t); });
        for (const std::uint32_t t : neighbours) {
            const HeldTriangle held(mesh_, mesh_.triangles[t]);
            near.for_each_overlapping(box_of(mesh_, mesh_.triangles[t]), [&](std::uint32_t other) {
                if (other != t && held.meeting(mesh_, mesh_.triangles[other]))
                    numbers.insert(numbers.end(), {t, other});
            });
        }
    }

    // Calls visit(triangle, its box) for all whose boxes overlap one.
    template <class Visit>
    void for_each_near(const BoxTree& chunks, const Box& box, const Visit& visit) const {
        chunks.for_each_overlapping(box, [&](std::uint32_t chunk) {
            const Box near = box.grown(boxes_.longest[chunk]);
            for_each_bit(stretches_near(box, chunk), [&](std::size_t stretch) {
                const std::size_t begin = chunk * TriangleBoxes::kChunk + stretch * TriangleBoxes::kStretch;
                for_each_bit(triangles_near(near, begin), [&](std::size_t i) {
                    const Triangle& triangle = mesh_.triangles[begin + i];
                    const Box of_triangle = box_of(mesh_, triangle);
                    if (of_triangle.overlaps(box) && !is_removed(triangle))
                        visit(static_cast<std::uint32_t>(begin + i), of_triangle);
                });
            });
        });
    }
    // Bit by bit, the stretches of a chunk that overlap a box. Without a branch, as the next one: they would often be
    // guessed wrong.
    std::uint64_t stretches_near(const Box& box, std::size_t chunk) const {
        constexpr std::size_t kStretches = TriangleBoxes::kChunk / TriangleBoxes::kStretch;
        const SmallBox small(box);
        std::uint64_t near = 0;
        for (std::size_t s = 0; s < kStretches; ++s)
            near |= std::uint64_t{small.overlaps(boxes_.stretches[chunk * kStretches + s])} << s;
        return near;
    }
    // The triangles of a stretch that have their first corner in a box.
    std::uint64_t triangles_near(const Box& box, std::size_t begin) const {
        const std::size_t end = std::min(begin + TriangleBoxes::kStretch, mesh_.triangles.size());
        std::uint64_t near = 0;
        for (std::size_t t = begin; t < end; ++t) {
            const Vec3& corner = mesh_.vertices[mesh_.triangles[t][0]];
            near |= std::uint64_t{box.overlaps({corner, corner})} << (t - begin);
        }
        return near;
    }

    // Mends in rounds; what it leaves below the needed angle is in left_ afterwards.
    void mend(std::vector<std::uint32_t> pending) {
        while (!pending.empty() && !gave_up()) pending = round(pending);
        std::sort(left_.begin(), left_.end());
        left_.erase(std::unique(left_.begin(), left_.end()), left_.end());
    }

    void drop_crumbs() {
        if (left_.empty() || options_.largest_crumb == 0) return;
        const BoxTree chunks(boxes_.chunks);
        for (const std::uint32_t t : left_) {
            if (is_removed(mesh_.triangles[t]) || !is_bad(mesh_.triangles[t])) continue;
            const std::vector<std::uint32_t> crumb = crumb_around(t, chunks);
            if (crumb.empty() || crumb.size() + removed_.size() == mesh_.triangles.size()) continue;
            std::vector<VertexId> corners;
            for (const std::uint32_t of_crumb : crumb) {
                Triangle& triangle = mesh_.triangles[of_crumb];
                corners.insert(corners.end(), triangle.begin(), triangle.end());
                triangle = {};
                removed_.push_back(of_crumb);
            }
            const std::vector<VertexId> vertices = LocalCorners(std::move(corners)).vertices();
            holes_.insert(holes_.end(), vertices.begin(), vertices.end());
            dropped_crumbs_ = true;
        }
    }

    // The triangles of a whole piece if it is a crumb, else nothing. On a sphere there are four less than twice as many
    // triangles as vertices, and on a part of one still fewer.
    std::vector<std::uint32_t> crumb_around(std::uint32_t triangle, const BoxTree& chunks) const {
        std::vector<std::uint32_t> crumb{triangle};
        std::vector<VertexId> corners(mesh_.triangles[triangle].begin(), mesh_.triangles[triangle].end());
        for (std::size_t i = 0; i < crumb.size() && crumb.size() <= options_.largest_crumb; ++i)
            for_each_near(chunks, box_of(mesh_, mesh_.triangles[crumb[i]]), [&](std::uint32_t t, const Box&) {
                const auto is_corner = [&](VertexId v) {
                    return std::find(corners.begin(), corners.end(), v) != corners.end();
                };
                const Triangle& triangle_t = mesh_.triangles[t];
                if (std::find(crumb.begin(), crumb.end(), t) != crumb.end()) return;
                if (std::none_of(triangle_t.begin(), triangle_t.end(), is_corner)) return;
                crumb.push_back(t);
                for (const VertexId v : mesh_.triangles[t])
                    if (!is_corner(v)) corners.push_back(v);
            });
        const bool whole = crumb.size() <= options_.largest_crumb && crumb.size() + 4 == 2 * corners.size();
        return whole ? crumb : std::vector<std::uint32_t>();
    }

    // Mends places far enough from each other side by side; returns the triangles that have to wait.
    std::vector<std::uint32_t> round(const std::vector<std::uint32_t>& pending) {
        std::vector<std::uint32_t> waiting;
        const std::vector<Place> places = choose_places(pending, waiting);
        const BoxTree chunks(boxes_.chunks);
        for (std::size_t begin = 0; begin < places.size() && !gave_up(); begin += kPlacesTogether)
            mend_places(chunks, std::span(places).subspan(begin, std::min(kPlacesTogether, places.size() - begin)));
        forget_tangled(places);
        return waiting;
    }

    // Of those of a round, side by side.
    void mend_places(const BoxTree& chunks, std::span<const Place> places) {
        std::vector<Cutting> cuttings(places.size());
        std::vector<Patch> mended(places.size());
        std::vector<std::size_t> hard_tries(places.size());
        parallel_for(places.size(), 1, [&](std::size_t i) {
            cuttings[i] = cut_out(chunks, places[i]);
            PatchMender mender(cuttings[i].patch, cuttings[i].free, cuttings[i].held, places[i].room, options_,
                               project_);
            mender.mend();
            if ((options_.search_everywhere || has_tangled(cuttings[i])) && mender.untangle()) mender.mend();
            mended[i] = mender.patch();
            hard_tries[i] = mender.hard_tries();
        });
        for (std::size_t i = 0; i < places.size(); ++i) {
            paste(cuttings[i], mended[i]);
            list_left(cuttings[i].triangles);
            hard_tries_ += hard_tries[i];
        }
    }

    // Those below the needed angle: suspects from the start, as that is no larger than the wanted one, or changed
    // since.
    void list_left(const std::vector<std::uint32_t>& triangles) {
        for (const std::uint32_t t : triangles)
            if (may_be_low_[t] && !is_removed(mesh_.triangles[t]) && goodness(mesh_.triangles[t]) < needed_)
                left_.push_back(t);
    }

    bool has_tangled(const Cutting& cutting) const {
        return std::any_of(cutting.triangles.begin(), cutting.triangles.end(),
                           [this](std::uint32_t t) { return is_tangled(t); });
    }

    // Tangled triangles have their turn together.
    void forget_tangled(const std::vector<Place>& places) {
        std::erase_if(tangled_, [&](std::uint32_t t) {
            return std::any_of(places.begin(), places.end(), [&](const Place& place) {
                return std::all_of(mesh_.triangles[t].begin(), mesh_.triangles[t].end(),
                                   [&](VertexId v) { return place.free.squared_distance(mesh_.vertices[v]) == 0.0; });
            });
        });
    }

    // Places whose rooms do not overlap, in the order of the triangles.
    std::vector<Place> choose_places(const std::vector<std::uint32_t>& pending, std::vector<std::uint32_t>& waiting) {
        std::vector<Place> places;
        std::map<std::array<int, 3>, std::vector<std::size_t>> cells;  // places by the cells that their rooms touch
        const double cell = 4.0 * reach_ * kRoom * options_.edge;
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
            const Place place{t, box.grown(reach_ * kFree * options_.edge), box.grown(reach_ * kRoom * options_.edge)};
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

    Cutting cut_out(const BoxTree& chunks, const Place& place) const {
        Cutting cutting;
        std::vector<VertexId> vertices;
        for_each_near(chunks, place.room, [&](std::uint32_t t, const Box&) {
            cutting.triangles.push_back(t);
            vertices.insert(vertices.end(), mesh_.triangles[t].begin(), mesh_.triangles[t].end());
        });
        const LocalCorners corners(std::move(vertices));
        cutting.vertices = corners.vertices();
        cutting.patch.points.reserve(cutting.vertices.size());
        std::vector<bool> sticks_out;
        for (const VertexId v : cutting.vertices) {
            const Vec3& place_of_v = mesh_.vertices[v];
            cutting.patch.points.push_back({place_of_v, mesh_.normals[v], 0.0});
            cutting.free.push_back(place.free.contains({place_of_v, place_of_v}));
            cutting.held.push_back(v < options_.held.size() && options_.held[v]);
            sticks_out.push_back(!place.room.contains({place_of_v, place_of_v}));
        }
        cutting.patch.triangles.reserve(cutting.triangles.size());
        for (const std::uint32_t number : cutting.triangles) {
            const Triangle& t = cutting.patch.triangles.emplace_back(corners.local(mesh_.triangles[number]));
            // Only vertices whose triangles lie wholly in the room are free: no other patch knows these.
            if (sticks_out[t[0]] || sticks_out[t[1]] || sticks_out[t[2]])
                for (const VertexId v : t) cutting.free[v] = false;
        }
        return cutting;
    }

    // Puts a patch back, with what it has more than before at the end of the mesh.
    void paste(Cutting& cutting, const Patch& after) {
        add_new(cutting, after);
        for (std::size_t v = 0; v < cutting.patch.points.size(); ++v) {
            if (after.points[v].position == cutting.patch.points[v].position) continue;
            mesh_.vertices[cutting.vertices[v]] = after.points[v].position;
            mesh_.normals[cutting.vertices[v]] = to_small(after.points[v].normal);
            moved_.push_back(cutting.vertices[v]);
        }
        for (const std::size_t t : changed_triangles(cutting.patch, after)) {
            const auto& [a, b, c] = after.triangles[t];
            const std::uint32_t number = cutting.triangles[t];
            const Triangle triangle{cutting.vertices[a], cutting.vertices[b], cutting.vertices[c]};
            mesh_.triangles[number] = triangle;
            changed_.push_back(number);
            may_be_low_[number] = true;
            if (is_removed(triangle))
                removed_.push_back(number);
            else
                boxes_.include(mesh_, number);
        }
        std::vector<bool> in_use(after.points.size());
        for (std::size_t t = 0; t < after.triangles.size(); ++t)
            if (after.has(t))
                for (const VertexId v : after.triangles[t]) in_use[v] = true;
        for (std::size_t v = 0; v < in_use.size(); ++v)
            if (!in_use[v]) holes_.push_back(cutting.vertices[v]);
    }

    void add_new(Cutting& cutting, const Patch& after) {
        const std::size_t known = cutting.vertices.size();
        for (std::size_t v = known; v < after.points.size(); ++v) {
            cutting.vertices.push_back(static_cast<VertexId>(mesh_.vertices.size()));
            mesh_.vertices.push_back(after.points[v].position);
            mesh_.normals.push_back(to_small(after.points[v].normal));
            moved_.push_back(cutting.vertices.back());
        }
        for (std::size_t t = cutting.triangles.size(); t < after.triangles.size(); ++t) {
            cutting.triangles.push_back(static_cast<std::uint32_t>(mesh_.triangles.size()));
            mesh_.triangles.push_back({0, 0, 0});
            boxes_.resize(mesh_.triangles.size());
            may_be_low_.push_back(true);
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

    // Vertices and triangles from the end take the places of removed ones.
    MeshChanges close_holes() {
        MeshChanges changes;
        changes.was_tangled = was_tangled_;
        changes.gave_up = gave_up();
        changes.with_new = mesh_.vertices.size();
        changes.left = changes.with_new - holes_.size();
        std::sort(removed_.begin(), removed_.end(), std::greater<>());
        for (const std::uint32_t t : removed_) {
            mesh_.triangles[t] = mesh_.triangles.back();
            mesh_.triangles.pop_back();
        }
        changed_.insert(changed_.end(), removed_.begin(), removed_.end());
        std::erase_if(changed_, [this](std::uint32_t t) { return t >= mesh_.triangles.size(); });
        std::sort(changed_.begin(), changed_.end());
        changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
        changes.triangles = std::move(changed_);
        changes.dropped_crumbs = dropped_crumbs_;
        if (!holes_.empty()) close_vertex_holes(changes);
        if (dropped_crumbs_) close_gaps(mesh_.components);
        std::sort(moved_.begin(), moved_.end());
        moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
        changes.moved = std::move(moved_);
        return changes;
    }

    void close_vertex_holes(MeshChanges& changes) {
        std::sort(holes_.begin(), holes_.end());
        auto last = static_cast<VertexId>(mesh_.vertices.size());
        std::vector<VertexId> number(holes_.size());  // new ones, of the vertices from `left` on
        for (const VertexId hole : holes_) {
            if (hole >= changes.left) break;
            do --last;
            while (std::binary_search(holes_.begin(), holes_.end(), last));
            changes.refilled.emplace_back(hole, last);
            number[last - changes.left] = hole;
        }
        std::erase_if(moved_, [this](VertexId v) { return std::binary_search(holes_.begin(), holes_.end(), v); });
        for (VertexId& v : moved_)
            if (v >= changes.left) v = number[v - changes.left];
        const auto left = static_cast<VertexId>(changes.left);
        parallel_chunks(mesh_.triangles.size(), kRenumbered, [&](std::size_t begin, std::size_t end) {
            const auto triangles = std::span(mesh_.triangles).subspan(begin, end - begin);
            if (triangle_kernels().find_largest_index(all_corners(triangles)) < left) return;
            for (Triangle& triangle : triangles)
                for (VertexId& v : triangle)
                    if (v >= left) v = number[v - left];
        });
        renumber_entries(changes, mesh_.vertices);
        renumber_entries(changes, mesh_.normals);
        renumber_entries(changes, mesh_.components);
    }

    Mesh& mesh_;
    const SliverOptions& options_;
    const SurfaceProjector& project_;
    double needed_;  // tangents
    double wanted_;
    double reach_ = 1.0;               // of kFree and kRoom
    std::vector<std::uint32_t> left_;  // triangles below the needed angle near places that have been mended
    std::vector<bool> may_be_low_;     // per triangle, whether it may be below the needed angle
    TriangleBoxes boxes_;
    std::vector<std::uint32_t> tangled_;  // triangles, as they were found, that have not had their turn
    bool was_tangled_ = false;
    std::size_t hard_tries_ = 0;
    bool dropped_crumbs_ = false;
    std::vector<VertexId> moved_;         // and new ones
    std::vector<VertexId> holes_;         // numbers of removed vertices
    std::vector<std::uint32_t> removed_;  // triangles
    std::vector<std::uint32_t> changed_;  // triangles that have changed, or vertices of theirs
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
