// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/finish_vertices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "core/bits.h"
#include "core/group_by.h"
#include "core/parallel_list.h"
#include "core/workspaces.h"
#include "grid/spline_block.h"
#include "nearest/box_features.h"
#include "nearest/feature_walk.h"
#include "nearest/local_features.h"
#include "nearest/nearest_batch.h"
#include "nearest/step_batch.h"
#include "platform/fresh_memory.h"
#include "project/shape_kernels.h"
#include "project/surface_projector.h"

namespace meniscus {
namespace {

// Neighbouring vertices, as many as are treated at once.
struct VertexRun {
    VertexId begin = 0;
    VertexId end = 0;
    SmallBox box;
};

// Runs of vertices in groups, each of one neighbourhood.
class RunGroups {
public:
    explicit RunGroups(std::span<const Vec3> points, double longest) {
        const auto found =
            parallel_list<VertexRun>(points.size(), kChunk, [&](std::size_t begin, std::size_t end, auto& runs) {
                for (std::size_t v = begin; v < end; v = runs.back().end)
                    runs.push_back(run_from(points.first(end), v, longest));
            });
        std::vector<BlockCoord> places;
        places.reserve(found.size());
        for (const VertexRun& run : found) places.push_back(place_of(run));
        groups_ = group_by<BlockCoordHash>(places);
        runs_.reserve(found.size());
        for (const std::uint32_t i : groups_.items) runs_.push_back(found[i]);
    }

    std::size_t size() const { return groups_.size(); }
    std::span<const VertexRun> runs(std::size_t group) const {
        return std::span(runs_).subspan(groups_.begins[group], groups_[group].size());
    }

private:
    static constexpr double kGroupEdge = 10.0;      // Å
    static constexpr double kMost = 2e9;            // of them along an axis: what is farther shares the last
    static constexpr std::size_t kChunk = 1 << 15;  // points per task

    static VertexRun run_from(std::span<const Vec3> points, std::size_t begin, double longest) {
        Box box;
        const std::size_t most = std::min(points.size(), begin + kBatchLanes);
        std::size_t end = begin;
        for (; end < most; ++end) {
            Box larger = box;
            larger.include(points[end]);
            const Vec3 size = larger.high - larger.low;
            if (std::max({size.x, size.y, size.z}) > longest && end > begin) break;
            box = larger;
        }
        return {static_cast<VertexId>(begin), static_cast<VertexId>(end), SmallBox(box)};
    }
    // In units of kGroupEdge.
    static BlockCoord place_of(const VertexRun& run) {
        const auto number = [](double x) {
            return static_cast<std::int32_t>(std::clamp(std::floor(x / kGroupEdge), -kMost, kMost));
        };
        const auto& [x, y, z] = run.box.low;
        return {.z = number(z), .y = number(y), .x = number(x)};
    }

    Groups groups_;
    std::vector<VertexRun> runs_;  // group after group
};

// Finds nearest features of points next to each other, and moves them onto the exact surface. A step along the distance
// ends there, but next to ridges the distance is a lower bound and steps fall short: there many are taken.
class ExactProjector {
public:
    explicit ExactProjector(const AccessibleSurface& surface)
        : around_(surface, kMargin), local_(surface, kMargin), batch_(surface), far_(surface) {}

    // Goes to a box whose points will be treated.
    void enter(const Box& box) { around_.gather(box.grown(kRoom)); }

    // What at most kBatchLanes points of a box are labelled with.
    void label(const Box& box, std::span<const Vec3> points, std::span<FeatureLabel> labels) {
        local_.gather_from(around_, box);
        const bool open = batch_.start(local_, box, kMargin) == NearestBatch::Claim::Open;
        if (open) batch_.find(points);
        others_.clear();
        places_.clear();
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            if (open && batch_.found(i)) {
                labels[i] = batch_.label(i);
            } else {
                others_.push_back(i);
                places_.push_back(points[i]);
            }
        }
        if (!others_.empty()) label_others(labels);
    }

    // Moves at most kBatchLanes points of a box to where they stay.
    void project(const Box& box, std::span<const Vec3> points, BatchSteps& steps) {
        local_.gather_from(around_, box.grown(kRoom));
        const bool open = batch_.start(local_, box, kMargin) == NearestBatch::Claim::Open;
        if (open) {
            batch_.find(points);
            batch_.steps_to_surface(steps);
        }
        others_.clear();
        places_.clear();
        for (std::uint32_t lane = 0; lane < points.size(); ++lane) {
            if (!open) steps.point[lane] = lane;
            if (open && steps.lanes.settled[lane] != 0) continue;
            const std::uint32_t i = steps.point[lane];
            if (open && batch_.found(i)) {
                others_.push_back(lane);
                places_.push_back(get_point(steps.lanes.points, lane));
            } else {
                Vec3 place = points[i];
                const NearestFeature at = walk_to_surface(local_, place, 0);
                steps.set(lane, place, at);
            }
        }
        walk_on(steps);
    }

private:
    static constexpr double kRoom = 0.25;   // Å: most points move less
    static constexpr double kMargin = 0.5;  // Å: points of a mesh are far nearer to the surface than this

    // Labels outliers, farther from the surface than the margin: a level set need not follow it.
    void label_others(std::span<FeatureLabel> labels) {
        far_.enter(box_of(places_));
        far_.find(places_, std::span(labels_));
        for (std::size_t i = 0; i < others_.size(); ++i) labels[others_[i]] = labels_[i];
    }

    // Moves on the points that a step may have left short of the surface: it has not left most.
    void walk_on(BatchSteps& steps) {
        if (places_.empty()) return;
        const Box box = box_of(places_);
        const bool open = local_.holds(box) && batch_.start(local_, box, kMargin) == NearestBatch::Claim::Open;
        if (open) batch_.find(places_);
        for (std::size_t i = 0; i < places_.size(); ++i) {
            Vec3 place = places_[i];
            const NearestFeature nearest = open && batch_.found(i) ? batch_.feature(i) : local_.nearest(place);
            const NearestFeature at = walk_from(local_, place, nearest, 1);
            steps.set(others_[i], place, at);
        }
    }

    LocalFeatures around_;  // of many runs
    LocalFeatures local_;
    NearestBatch batch_;
    BoxFeatures far_;
    std::vector<std::uint32_t> others_;             // lanes of outliers, for which one step or search is not enough
    std::vector<Vec3> places_;                      // their places
    std::array<FeatureLabel, kBatchLanes> labels_;  // of the outliers
};

constexpr std::size_t kGroupsPerTask = 2;
constexpr double kLongestRun = 9.0;  // spacings: little more than a block

std::vector<Vec3> places_of(const Mesh& mesh, const std::vector<VertexId>& vertices) {
    constexpr std::size_t kPerChunk = 1 << 14;
    std::vector<Vec3> places;
    resize_touched(places, vertices.size());
    parallel_chunks(vertices.size(), kPerChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) places[i] = mesh.vertices[vertices[i]];
    });
    return places;
}

SmallBox box_of(std::span<const VertexRun> runs) {
    SmallBox box;
    for (const VertexRun& run : runs) box.include(run.box);
    return box;
}

// Moves vertices onto the zero set of a level set and gives them what is known of the surface there.
class LevelSetFinisher {
public:
    LevelSetFinisher(const ProjectionTarget& target, Mesh& mesh)
        : accessible_(target.accessible), level_set_(*target.level_set), spacing_(target.spacing), mesh_(mesh) {
        resize_touched(distances_, mesh.vertices.size());
    }

    // Returns the distances to the exact surface.
    VertexDistances run() {
        search(project());
        return VertexDistances(std::move(distances_));
    }

private:
    // What is used again for the next vertices.
    struct ProjectionRoom {
        explicit ProjectionRoom(const LevelSet& level_set) : spline(level_set.grid(), level_set.coefficients()) {}

        SplineBlock spline;
        std::array<SplineProjection, kBatchLanes> projections;
        std::array<FeatureCell, kBatchLanes> cells;
        ShapeLanes shapes;
    };
    struct SearchRoom {
        explicit SearchRoom(const AccessibleSurface& accessible) : projector(accessible) {}

        ExactProjector projector;
        std::array<FeatureLabel, kBatchLanes> labels;
    };

    // Returns the vertices that are not labelled yet.
    std::vector<VertexId> project() {
        const RunGroups groups(mesh_.vertices, kLongestRun * spacing_);
        return parallel_list_with<VertexId>(
            groups.size(), kGroupsPerTask, [&] { return std::make_unique<ProjectionRoom>(level_set_); },
            [&](std::size_t begin, std::size_t end, ProjectionRoom& room, std::vector<VertexId>& left) {
                FeatureWalk walk(accessible_);
                for (std::size_t g = begin; g < end; ++g)
                    for (const VertexRun& run : groups.runs(g)) project(run, room, walk, left);
            });
    }
    void project(const VertexRun& run, ProjectionRoom& room, FeatureWalk& walk, std::vector<VertexId>& left) {
        auto& [spline, projections, cells, shapes] = room;
        const std::size_t count = run.end - run.begin;
        const std::span<Vec3> vertices = std::span(mesh_.vertices).subspan(run.begin, count);
        spline.project(vertices, projections);
        shape_kernels().of_projections(projections, count, shapes);
        for (std::size_t lane = 0; lane < count; ++lane) {
            vertices[lane] = projections[lane].point;
            mesh_.normals[run.begin + lane] = to_small(get_point(shapes.normals, lane));
        }
        walk.find(vertices, cells);
        for (std::size_t lane = 0; lane < count; ++lane) {
            const auto v = static_cast<VertexId>(run.begin + lane);
            if (cells[lane].kind != FeatureCell::Kind::None)
                set_label(v, label_in(accessible_.data(), vertices[lane], cells[lane]));
            else
                left.push_back(v);
        }
        set_curvatures(run, shapes);
    }

    // Labels the vertices that are left.
    void search(const std::vector<VertexId>& left) {
        const std::vector<Vec3> points = places_of(mesh_, left);
        const RunGroups groups(points, kLongestRun * spacing_);
        parallel_chunks_with(
            groups.size(), kGroupsPerTask, [&] { return std::make_unique<SearchRoom>(accessible_); },
            [&](std::size_t begin, std::size_t end, SearchRoom& room) {
                for (std::size_t g = begin; g < end; ++g) search(groups.runs(g), left, points, room);
            });
    }
    void search(std::span<const VertexRun> runs, std::span<const VertexId> left, std::span<const Vec3> points,
                SearchRoom& room) {
        room.projector.enter(box_of(runs).box());
        for (const VertexRun& run : runs) {
            const std::size_t count = run.end - run.begin;
            room.projector.label(run.box.box(), points.subspan(run.begin, count), room.labels);
            for (std::size_t i = 0; i < count; ++i) set_label(left[run.begin + i], room.labels[i]);
        }
    }

    void set_label(VertexId v, const FeatureLabel& label) {
        mesh_.atoms[v] = label.atom;
        mesh_.patches[v] = label.patch;
        distances_[v] = static_cast<float>(std::abs(label.signed_distance));
    }

    // A grid cannot tell more than 1/spacing.
    void set_curvatures(const VertexRun& run, ShapeLanes& shapes) {
        const std::size_t count = run.end - run.begin;
        shape_kernels().cap(1.0 / spacing_, count, shapes);
        std::copy_n(shapes.capped_mean.at, count, &mesh_.mean_curvatures[run.begin]);
        std::copy_n(shapes.capped_gaussian.at, count, &mesh_.gaussian_curvatures[run.begin]);
        std::copy_n(shapes.shape_index.at, count, &mesh_.shape_indices[run.begin]);
    }

    const AccessibleSurface& accessible_;
    const LevelSet& level_set_;
    double spacing_;
    Mesh& mesh_;
    std::vector<float> distances_;
};

// Moves vertices onto the exact surface and gives them what is known of it there. Most of them take a single step from
// a place whose nearest feature a walk from the one before finds. What is nearest to those beside ridges is searched
// for among all that is there.
class ExactFinisher {
public:
    ExactFinisher(const ProjectionTarget& target, Mesh& mesh)
        : accessible_(target.accessible), spacing_(target.spacing), mesh_(mesh) {}

    // Returns the distances to the surface.
    VertexDistances run() {
        left_ = accessible_.probe() > 0.0 ? walk() : all();  // a StepBatch needs a probe
        points_ = places_of(mesh_, left_);
        distances_.resize(left_.size());
        search();
        return {mesh_.vertices.size(), off()};
    }

private:
    static constexpr std::size_t kVerticesPerTask = 1 << 12;

    // What is used again for the next vertices.
    struct StepRoom {
        explicit StepRoom(const AccessibleSurface& accessible) : stepper(accessible) {}

        std::array<FeatureCell, kBatchLanes> cells;
        StepBatch stepper;
        BatchSteps steps;
        ShapeLanes shapes;
    };
    struct SearchRoom {
        explicit SearchRoom(const AccessibleSurface& accessible) : projector(accessible) {}

        ExactProjector projector;
        BatchSteps steps;
        ShapeLanes shapes;
    };

    std::vector<VertexId> all() const {
        std::vector<VertexId> vertices(mesh_.vertices.size());
        std::iota(vertices.begin(), vertices.end(), VertexId{0});
        return vertices;
    }

    // Returns those that are left, in rising order.
    std::vector<VertexId> walk() {
        return parallel_list_with<VertexId>(
            mesh_.vertices.size(), kVerticesPerTask, [&] { return std::make_unique<StepRoom>(accessible_); },
            [&](std::size_t begin, std::size_t end, StepRoom& room, std::vector<VertexId>& left) {
                FeatureWalk walk(accessible_);
                for (std::size_t v = begin; v < end; v += kBatchLanes)
                    for_each_bit(step(v, std::min(end, v + kBatchLanes), walk, room),
                                 [&](std::size_t i) { left.push_back(static_cast<VertexId>(v + i)); });
            });
    }
    // Returns, bit by bit, which are left.
    std::uint64_t step(std::size_t begin, std::size_t end, FeatureWalk& walk, StepRoom& room) {
        static_assert(kBatchLanes <= 64);
        auto& [cells, stepper, steps, shapes] = room;
        walk.find(std::span(mesh_.vertices).subspan(begin, end - begin), cells);
        stepper.clear();
        std::uint64_t left = first_bits(end - begin);
        for (std::size_t v = begin; v < end; ++v) {
            const FeatureCell& cell = cells[v - begin];
            if (cell.kind != FeatureCell::Kind::None)
                stepper.add(static_cast<std::uint32_t>(v - begin), mesh_.vertices[v], cell);
        }
        const std::size_t count = stepper.take(steps);
        cap_curvatures(steps, count, shapes);
        for (std::size_t lane = 0; lane < count; ++lane) {
            if (steps.lanes.settled[lane] == 0) continue;
            write(steps, shapes, lane, begin + steps.point[lane]);
            left &= ~(std::uint64_t{1} << steps.point[lane]);
        }
        return left;
    }

    // Projects the vertices that are left.
    void search() {
        const RunGroups groups(points_, kLongestRun * spacing_);
        parallel_chunks_with(
            groups.size(), kGroupsPerTask, [&] { return std::make_unique<SearchRoom>(accessible_); },
            [&](std::size_t begin, std::size_t end, SearchRoom& room) {
                for (std::size_t g = begin; g < end; ++g) search(groups.runs(g), room);
            });
    }
    void search(std::span<const VertexRun> runs, SearchRoom& room) {
        auto& [projector, steps, shapes] = room;
        projector.enter(box_of(runs).box());
        for (const VertexRun& run : runs) {
            const std::size_t count = run.end - run.begin;
            projector.project(run.box.box(), std::span(points_).subspan(run.begin, count), steps);
            cap_curvatures(steps, count, shapes);
            for (std::size_t lane = 0; lane < count; ++lane) {
                const std::size_t i = run.begin + steps.point[lane];
                write(steps, shapes, lane, left_[i]);
                distances_[i] = static_cast<float>(std::abs(steps.signed_distance[lane]));
            }
        }
    }

    // The vertices that are not on the surface, in rising order.
    std::vector<VertexDistances::Off> off() const {
        std::vector<VertexDistances::Off> list;
        for (std::size_t i = 0; i < left_.size(); ++i)
            if (distances_[i] != 0.0F) list.push_back({left_[i], distances_[i]});
        return list;
    }

    // At cusps there is no limit to them.
    void cap_curvatures(const BatchSteps& steps, std::size_t count, ShapeLanes& shapes) const {
        shapes.mean = steps.lanes.mean;
        shapes.gaussian = steps.lanes.gaussian;
        shape_kernels().cap(1.0 / spacing_, count, shapes);
    }
    void write(const BatchSteps& steps, const ShapeLanes& shapes, std::size_t lane, std::size_t v) {
        mesh_.vertices[v] = get_point(steps.lanes.points, lane);
        mesh_.normals[v] = to_small(get_point(steps.lanes.normals, lane));
        mesh_.mean_curvatures[v] = shapes.capped_mean[lane];
        mesh_.gaussian_curvatures[v] = shapes.capped_gaussian[lane];
        mesh_.shape_indices[v] = shapes.shape_index[lane];
        mesh_.atoms[v] = steps.atom[lane];
        mesh_.patches[v] = steps.patch[lane];
    }

    const AccessibleSurface& accessible_;
    double spacing_;
    Mesh& mesh_;
    std::vector<VertexId> left_;  // for search()
    std::vector<Vec3> points_;    // of them
    std::vector<float> distances_;
};

}  // namespace

VertexDistances finish_vertices(const ProjectionTarget& target, Mesh& mesh) {
    resize_all_touched(mesh.vertices.size(), mesh.normals, mesh.atoms, mesh.patches, mesh.mean_curvatures,
                       mesh.gaussian_curvatures, mesh.shape_indices);
    if (target.level_set != nullptr) return LevelSetFinisher(target, mesh).run();
    return ExactFinisher(target, mesh).run();
}

void finish_again(const ProjectionTarget& target, std::span<const VertexStart> starts, Mesh& mesh,
                  VertexDistances& distances) {
    Mesh again;
    again.vertices.reserve(starts.size());
    for (const VertexStart& start : starts) again.vertices.push_back(start.from);
    const VertexDistances found = finish_vertices(target, again);
    for (VertexId i = 0; i < starts.size(); ++i) {
        const VertexId v = starts[i].vertex;
        mesh.vertices[v] = again.vertices[i];
        mesh.normals[v] = again.normals[i];
        mesh.atoms[v] = again.atoms[i];
        mesh.patches[v] = again.patches[i];
        mesh.mean_curvatures[v] = again.mean_curvatures[i];
        mesh.gaussian_curvatures[v] = again.gaussian_curvatures[i];
        mesh.shape_indices[v] = again.shape_indices[i];
        distances.set(v, found[i]);
    }
}

}  // namespace meniscus
