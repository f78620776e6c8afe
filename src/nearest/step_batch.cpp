// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/step_batch.h"

#include <algorithm>
#include <limits>

namespace meniscus {

void BatchSteps::set(std::size_t lane, const Vec3& place, const NearestFeature& at) {
    set_point(lanes.points, lane, place);
    set_point(lanes.normals, lane, at.normal);
    lanes.mean[lane] = at.mean_curvature;
    const bool equal = at.patch != PatchKind::Toroidal;
    lanes.gaussian[lane] = equal ? std::numeric_limits<double>::infinity() : at.gaussian_curvature;
    atom[lane] = at.atom;
    patch[lane] = at.patch;
    signed_distance[lane] = at.signed_distance;
}

// In the order of the lanes: kernels write beyond the last one of theirs.
std::size_t StepBatch::take(BatchSteps& steps) {
    std::size_t count = step_from_balls(0, steps);
    count += step_from_arcs(count, steps);
    count += step_from_vertices(count, steps);
    std::fill_n(steps.signed_distance.at, count, 0.0);
    return count;
}

std::size_t StepBatch::step_from_balls(std::size_t to, BatchSteps& steps) {
    const Points& points = points_of(FeatureCell::Kind::Ball);
    for (std::size_t k = 0; k < points.count; ++k) {
        const std::uint32_t atom = points.feature[k];
        set_point(ball_lanes_.centre, k, data_->atoms.centres[atom]);
        ball_lanes_.radius[k] = data_->rho[atom] - data_->probe;
    }
    kernels_.step_from_balls(points.places, ball_lanes_, points.count, to, steps.lanes);
    write_labels(points, {steps, to, PatchKind::Contact}, [&](std::size_t k) { return points.feature[k]; });
    return points.count;
}

std::size_t StepBatch::step_from_arcs(std::size_t to, BatchSteps& steps) {
    const Points& points = points_of(FeatureCell::Kind::Arc);
    for (std::size_t k = 0; k < points.count; ++k) arc_lanes_.set(k, data_->arcs[points.feature[k]], data_->atoms);
    kernels_.step_from_arcs(data_->probe, points.places, arc_lanes_, points.count, to, steps.lanes, nearest_);
    write_labels(points, {steps, to, PatchKind::Toroidal}, [&](std::size_t k) {
        return data_->arcs[points.feature[k]].atoms[static_cast<std::size_t>(nearest_[k])];
    });
    return points.count;
}

std::size_t StepBatch::step_from_vertices(std::size_t to, BatchSteps& steps) {
    const Points& points = points_of(FeatureCell::Kind::Vertex);
    for (std::size_t k = 0; k < points.count; ++k)
        vertex_lanes_.set(k, data_->vertices[points.feature[k]], data_->atoms);
    kernels_.step_from_vertices(data_->probe, points.places, vertex_lanes_, points.count, to, steps.lanes, nearest_);
    write_labels(points, {steps, to, PatchKind::Reentrant}, [&](std::size_t k) {
        return data_->vertices[points.feature[k]].atoms[static_cast<std::size_t>(nearest_[k])];
    });
    return points.count;
}

}  // namespace meniscus
