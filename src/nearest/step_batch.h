// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Steps to the surface, side by side, of up to 64 points whose nearest features are known.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "nearest/nearest_feature.h"
#include "nearest/nearest_kernels.h"

namespace meniscus {

/// Steps from a batch of points to the surface, in an order of its own.
struct BatchSteps {
    StepLanes lanes;
    LaneArray<std::uint32_t> point;  ///< where in the batch the step began
    LaneArray<std::uint32_t> atom;   ///< as in NearestFeature
    LaneArray<PatchKind> patch;
    /// Where the step ends, Å: 0 as StepBatch takes it, settled or not; else what set() was given.
    LaneArray<double> signed_distance;

    /// What is nearest to a place that was found otherwise.
    void set(std::size_t lane, const Vec3& place, const NearestFeature& at);
};

/// Sorts points by the kinds of their features, for all of a kind to step at once. The probe's radius must not be 0:
/// then arcs and vertices are on the surface, and no direction leads to them.
class StepBatch {
public:
    explicit StepBatch(const AccessibleSurface& surface, const NearestKernels& kernels = nearest_kernels())
        : data_(&surface.data()), kernels_(kernels) {}

    void clear() {
        for (Points& of_kind : points_) of_kind.count = 0;
    }
    /// Adds a point of the batch, and what is nearest to it; the kind is no branch, which could not be predicted.
    void add(std::uint32_t point, const Vec3& place, const FeatureCell& nearest) {
        Points& of_kind = points_of(nearest.kind);
        const std::size_t lane = of_kind.count++;
        of_kind.point[lane] = point;
        of_kind.feature[lane] = nearest.index;
        set_point(of_kind.places, lane, place);
    }
    /// Takes the steps of all points added, as SurfaceStep has them, and returns their number.
    std::size_t take(BatchSteps& steps);

private:
    struct Points {
        std::size_t count = 0;
        LaneArray<std::uint32_t> point;
        LaneArray<std::uint32_t> feature;
        LanePoints<double> places;
    };

    // Lanes of steps, from one on, that are of the same kind of patch.
    struct Target {
        BatchSteps& steps;
        std::size_t to;
        PatchKind patch;
    };
    // Says whose the points of a kind are. atom_of(k): the nearest atom of point k's feature.
    template <class AtomOf>
    void write_labels(const Points& points, const Target& target, const AtomOf& atom_of) const {
        const auto& [steps, to, patch] = target;
        for (std::size_t k = 0; k < points.count; ++k) {
            steps.point[to + k] = points.point[k];
            steps.atom[to + k] = data_->atoms.original[atom_of(k)];
            steps.patch[to + k] = patch;
        }
    }
    Points& points_of(FeatureCell::Kind kind) { return points_[static_cast<std::size_t>(kind)]; }
    std::size_t step_from_balls(std::size_t to, BatchSteps& steps);
    std::size_t step_from_arcs(std::size_t to, BatchSteps& steps);
    std::size_t step_from_vertices(std::size_t to, BatchSteps& steps);

    const AccessibleSurface::Data* data_;
    NearestKernels kernels_;
    std::array<Points, 4> points_;  // by the kind of their features
    BallLanes ball_lanes_;
    ArcLanes arc_lanes_;
    VertexLanes vertex_lanes_;
    LaneArray<std::int64_t> nearest_;  // of the atoms of each feature
};

}  // namespace meniscus
