// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/local_features.h"

#include <algorithm>

#include "core/parallel.h"
#include "geometry/nearest_batch.h"
#include "geometry/nearest_feature.h"
#include "geometry/nearest_kernels.h"

namespace meniscus {
namespace {

constexpr double kCellSlack = 1e-6;  // Å, for rounding at the borders of cells
constexpr std::size_t kPointsPerChunk = 2048;
constexpr double kMargin = 0.5;  // Å: points of a mesh are far nearer than this

// Groups of points that share lists. Larger ones are split; few points are cheaper one by one.
constexpr std::size_t kPointsPerGather = 512;
constexpr double kGatherDiagonal = 18.0;  // Å
constexpr double kBatchDiagonal = 9.0;    // Å
constexpr std::size_t kFewPoints = 4;

double diagonal(const Box& box) { return norm(box.high - box.low); }

Box box_of(std::span<const Vec3> points) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    return box;
}

class GroupSearch {
public:
    explicit GroupSearch(const AccessibleSurface& surface, double margin = kMargin)
        : surface_(surface), wide_(surface, margin), batch_(surface) {}

    void find(std::span<const Vec3> points, std::span<NearestFeature> result) {
        const Box box = box_of(points);
        if (points.size() <= kFewPoints) return find_one_by_one(points, result);
        if (points.size() > kPointsPerGather || diagonal(box) > kGatherDiagonal) {
            const std::size_t half = points.size() / 2;
            find(points.first(half), result.first(half));
            return find(points.subspan(half), result.subspan(half));
        }
        wide_.gather(box);
        find_within(wide_, points, result);
    }

    void find_within(const LocalFeatures& wide, std::span<const Vec3> points, std::span<NearestFeature> result) {
        const Box box = box_of(points);
        if (points.size() > kBatchLanes || (diagonal(box) > kBatchDiagonal && points.size() > kFewPoints)) {
            const std::size_t half = points.size() / 2;
            find_within(wide, points.first(half), result.first(half));
            return find_within(wide, points.subspan(half), result.subspan(half));
        }
        find_batch(wide, box, points, result);
    }

private:
    void find_one_by_one(std::span<const Vec3> points, std::span<NearestFeature> result) const {
        std::transform(points.begin(), points.end(), result.begin(),
                       [&](const Vec3& p) { return surface_.nearest(p); });
    }

    void find_batch(const LocalFeatures& wide, const Box& box, std::span<const Vec3> points,
                    std::span<NearestFeature> result) {
        if (batch_.start(wide, box, wide.margin()) != NearestBatch::Claim::Open) return find_one_by_one(points, result);
        batch_.find(points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const bool found =
                batch_.claim(i) == NearestBatch::Claim::Ball || batch_.claim(i) == NearestBatch::Claim::Edge;
            result[i] = found ? batch_.feature(i) : surface_.nearest(points[i]);
        }
    }

    const AccessibleSurface& surface_;
    LocalFeatures wide_;
    NearestBatch batch_;
};

}  // namespace

// In K the nearest ball may not reach the box; it is within margin of the probe's contact all the same.
double LocalFeatures::beyond_balls() const { return std::max(0.0, margin_ - surface_->data().probe); }

void LocalFeatures::gather(const Box& box) {
    const AccessibleSurface::Data& data = surface_->data();
    const double beyond = beyond_balls();
    balls_.clear();
    data.atom_tree.for_each_overlapping(box.grown(data.rho_max + beyond), [&](std::uint32_t i) {
        const double reach = data.rho[i] + beyond;
        const Vec3& c = data.atoms.centres[i];
        if (box.squared_distance(c) < reach * reach) balls_.add({c.x, c.y, c.z, data.rho[i]}, i);
    });
    arcs_.clear();
    data.arc_cell_tree.for_each_overlapping(box.grown(kCellSlack), [&](std::uint32_t a) {
        const Box cell = data.arc_cells[a].grown(kCellSlack);
        if (!data.arcs[a].is_a_point())
            arcs_.add({cell.low.x, cell.low.y, cell.low.z, cell.high.x, cell.high.y, cell.high.z}, a);
    });
    vertices_.clear();
    const double reach = data.probe + margin_;
    data.vertex_tree.for_each_overlapping(box.grown(reach), [&](std::uint32_t v) {
        const Vec3& p = data.vertices[v].position;
        if (box.squared_distance(p) < reach * reach) vertices_.add({p.x, p.y, p.z, data.probe}, v);
    });
}

void LocalFeatures::gather_from(const LocalFeatures& wider, const Box& box) {
    const NearestKernels& kernels = nearest_kernels();
    marks_.resize(std::max({marks_.size(), wider.balls_.padded_size(), wider.arcs_.padded_size(),
                            wider.vertices_.padded_size()}));
    kernels.mark_reaching(wider.balls_, beyond_balls(), box, marks_.data());
    balls_.select(wider.balls_, marks_);
    kernels.mark_overlapping(wider.arcs_, box, marks_.data());
    arcs_.select(wider.arcs_, marks_);
    kernels.mark_reaching(wider.vertices_, margin_, box, marks_.data());
    vertices_.select(wider.vertices_, marks_);
}

NearestFeature LocalFeatures::nearest(const Vec3& point) const {
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

std::vector<NearestFeature> nearest_features(const AccessibleSurface& surface, std::span<const Vec3> points) {
    std::vector<NearestFeature> result(points.size());
    parallel_chunks(points.size(), kPointsPerChunk, [&](std::size_t begin, std::size_t end) {
        GroupSearch(surface).find(points.subspan(begin, end - begin), std::span(result).subspan(begin, end - begin));
    });
    return result;
}

void nearest_features(const LocalFeatures& gathered, std::span<const Vec3> points, std::span<NearestFeature> result) {
    GroupSearch(gathered.surface(), gathered.margin()).find_within(gathered, points, result);
}

}  // namespace meniscus
