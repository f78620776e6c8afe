// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/local_features.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"
#include "nearest/feature_walk.h"
#include "nearest/nearest_batch.h"
#include "nearest/nearest_kernels.h"
#include "space/cell_order.h"

namespace meniscus {
namespace {

constexpr double kCellSlack = 1e-6;  // Å, for rounding at the borders of cells
constexpr double kMargin = 0.5;      // Å: points of a mesh are far nearer to the surface than this

constexpr std::size_t kPointsPerChunk = 8192;
constexpr double kCellEdge = 8.0;             // Å: the points of a cell share their lists of features
constexpr std::size_t kMostCells = 1U << 14;  // more mean that points are far apart
constexpr std::size_t kFewPoints = 4;         // cheaper one by one
constexpr std::size_t kTriedFirst = 256;      // points that walk in any case
constexpr std::size_t kWorthWalking = 4;      // no more do where fewer than one of so many came to their cell

// What a search tells of a point: of its nearest feature, or where that is not known yet.
struct FeatureAnswer {
    using Result = NearestFeature;
    static Result of(const AccessibleSurface& surface, const Vec3& point, const FeatureCell& nearest) {
        return feature_in(surface.data(), point, nearest);
    }
    static Result of(const AccessibleSurface& surface, const Vec3& point) { return surface.nearest(point); }
};
struct StepAnswer {
    using Result = SurfaceStep;
    static Result of(const AccessibleSurface& surface, const Vec3& point, const FeatureCell& nearest) {
        return step_from(surface.data(), point, nearest);
    }
    static Result of(const AccessibleSurface& surface, const Vec3& point) {
        const NearestFeature at = surface.nearest(point);
        return {point - at.signed_distance * at.normal, at, at.signed_distance == 0.0};
    }
};

template <class Answer>
class GroupSearch {
public:
    using Result = typename Answer::Result;

    explicit GroupSearch(const AccessibleSurface& surface) : surface_(surface), batch_(surface) {}

    void find(std::span<const Vec3> points, std::span<Result> result) {
        if (points.size() <= kFewPoints)
            return find_one_by_one(points, [&](std::size_t i) -> Result& { return result[i]; });
        CellOrder cells;
        if (!cells.sort(points, kCellEdge, kMostCells)) {
            const std::size_t half = points.size() / 2;
            find(points.first(half), result.first(half));
            return find(points.subspan(half), result.subspan(half));
        }
        LocalFeatures local(surface_, kMargin);
        for (std::size_t cell = 0; cell < cells.size(); ++cell) {
            const auto [group, positions] = cells[cell];
            const auto place = [&positions = positions, result](std::size_t i) -> Result& {
                return result[positions[i]];
            };
            if (group.size() <= kFewPoints) {
                find_one_by_one(group, place);
                continue;
            }
            local.gather(box_of(group));
            find_within(local, group, place);
        }
    }

    // Where place(i) is the one for the answer to points[i].
    template <class Place>
    void find_within(const LocalFeatures& local, std::span<const Vec3> points, const Place& place) {
        for (std::size_t at = 0; at < points.size(); at += kBatchLanes) {
            const std::span<const Vec3> batch = points.subspan(at, std::min(kBatchLanes, points.size() - at));
            const bool open = batch_.start(local, box_of(batch), local.margin()) == NearestBatch::Claim::Open;
            if (open) batch_.find(batch);
            for (std::size_t i = 0; i < batch.size(); ++i)
                place(at + i) = open && batch_.found(i) ? Answer::of(surface_, batch[i], batch_.nearest(i))
                                                        : Answer::of(surface_, batch[i]);
        }
    }

private:
    template <class Place>
    void find_one_by_one(std::span<const Vec3> points, const Place& place) const {
        for (std::size_t i = 0; i < points.size(); ++i) place(i) = Answer::of(surface_, points[i]);
    }

    const AccessibleSurface& surface_;
    NearestBatch batch_;
};

// Points near the surface are mostly in the cell of a feature that a walk from the one before finds; the others are
// searched for in groups.
template <class Answer>
void find_answers(const AccessibleSurface& surface, std::span<const Vec3> points,
                  std::span<typename Answer::Result> result) {
    FeatureWalk walk(surface);
    std::array<FeatureCell, kBatchLanes> cells;
    std::vector<std::uint32_t> left;
    std::vector<Vec3> places;
    for (std::size_t begin = 0; begin < points.size(); begin += kBatchLanes) {
        const std::span<const Vec3> batch = points.subspan(begin, std::min(kBatchLanes, points.size() - begin));
        const bool walks = begin < kTriedFirst || kWorthWalking * (begin - left.size()) > begin;
        cells.fill({});
        if (walks) walk.find(batch, cells);
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (cells[i].kind != FeatureCell::Kind::None) {
                result[begin + i] = Answer::of(surface, batch[i], cells[i]);
                continue;
            }
            left.push_back(static_cast<std::uint32_t>(begin + i));
            places.push_back(batch[i]);
        }
    }
    std::vector<typename Answer::Result> found(left.size());
    GroupSearch<Answer>(surface).find(places, found);
    for (std::size_t i = 0; i < left.size(); ++i) result[left[i]] = found[i];
}

template <class Answer>
std::vector<typename Answer::Result> answers(const AccessibleSurface& surface, std::span<const Vec3> points) {
    std::vector<typename Answer::Result> result(points.size());
    parallel_chunks(points.size(), kPointsPerChunk, [&](std::size_t begin, std::size_t end) {
        find_answers<Answer>(surface, points.subspan(begin, end - begin),
                             std::span(result).subspan(begin, end - begin));
    });
    return result;
}

}  // namespace

// In K the nearest ball may not reach the box; it is within margin of the probe's contact all the same.
double LocalFeatures::beyond_balls() const { return std::max(0.0, margin_ - surface_->data().probe); }

void LocalFeatures::gather(const Box& box) {
    const AccessibleSurface::Data& data = surface_->data();
    const double beyond = beyond_balls();
    box_ = box;
    balls_.clear();
    data.atom_tree.for_each_overlapping(box.grown(data.rho_max + beyond), [&](std::uint32_t i) {
        const double reach = data.rho[i] + beyond;
        const Vec3& c = data.atoms.centres[i];
        balls_.add_if(box.squared_distance(c) < reach * reach, {c.x, c.y, c.z, data.rho[i]}, i);
    });
    arcs_.clear();
    data.arc_cell_tree.for_each_overlapping(box.grown(kCellSlack), [&](std::uint32_t a) {
        arcs_.add(row_of(data.arc_cell_tree.box(a).grown(kCellSlack)), a);
    });
    vertices_.clear();
    const double reach = data.probe + margin_;
    data.vertex_tree.for_each_overlapping(box.grown(reach), [&](std::uint32_t v) {
        const Vec3& p = data.vertices[v].position;
        vertices_.add_if(box.squared_distance(p) < reach * reach, {p.x, p.y, p.z, data.probe}, v);
    });
}

void LocalFeatures::gather_from(const LocalFeatures& wider, const Box& box) {
    const NearestKernels& kernels = nearest_kernels();
    box_ = box;
    marks_.resize(std::max({marks_.size(), words_for(wider.balls_.size()), words_for(wider.arcs_.size()),
                            words_for(wider.vertices_.size())}));
    kernels.mark_reaching(wider.balls_, beyond_balls(), box, marks_.data());
    balls_.select(wider.balls_, marks_.data());
    kernels.mark_overlapping(wider.arcs_, box, marks_.data());
    arcs_.select(wider.arcs_, marks_.data());
    kernels.mark_reaching(wider.vertices_, margin_, box, marks_.data());
    vertices_.select(wider.vertices_, marks_.data());
}

NearestFeature LocalFeatures::nearest(const Vec3& point) const {
    if (!(box_.squared_distance(point) == 0.0)) return surface_->nearest(point);
    const AccessibleSurface::Data& data = surface_->data();
    NearestBall ball;
    for (std::size_t b = 0; b < balls_.size(); ++b) {
        const double l = norm(point - position_in(balls_, b));
        ball.offer(balls_.index(b), balls_.column(3)[b] - l, l);
    }
    if (ball.depth <= -beyond_balls()) return surface_->nearest(point);  // a nearer one may not be listed
    if (owned_by_ball(data, ball, point)) return contact_feature(data, point, ball);
    NearestEdge edge;
    for (std::size_t a = 0; a < arcs_.size(); ++a)
        edge.offer_arc(arcs_.index(a), foot_on_arc(data.arcs[arcs_.index(a)], point));
    for (std::size_t v = 0; v < vertices_.size(); ++v)
        edge.offer_vertex(vertices_.index(v), squared_norm(point - position_in(vertices_, v)));
    const double reach = data.probe + margin_;
    if (edge.squared_distance >= reach * reach) return surface_->nearest(point);
    return edge_feature(data, point, edge);
}

void check_finite(std::span<const Vec3> points) {
    const auto is_wrong = [](const Vec3& point) { return !is_finite(point); };
    if (!parallel_any_of(points, is_wrong)) return;
    const auto first = std::find_if(points.begin(), points.end(), is_wrong) - points.begin();
    throw std::invalid_argument("point " + std::to_string(first) + " is not finite");
}

std::vector<NearestFeature> nearest_features(const AccessibleSurface& surface, std::span<const Vec3> points) {
    check_finite(points);
    return answers<FeatureAnswer>(surface, points);
}

std::vector<SurfaceStep> steps_to_surface(const AccessibleSurface& surface, std::span<const Vec3> points) {
    return answers<StepAnswer>(surface, points);
}

void nearest_features(const LocalFeatures& gathered, std::span<const Vec3> points, std::span<NearestFeature> result) {
    GroupSearch<FeatureAnswer>(gathered.surface()).find_within(gathered, points, [&](std::size_t i) -> NearestFeature& {
        return result[i];
    });
}

}  // namespace meniscus
