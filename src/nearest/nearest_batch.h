// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The nearest features of up to 64 neighbouring points at once.
//
// Whose a point is follows from the same tests as in nearest_feature.h, with the points as the lanes of vectors. Only
// the deepest ball is looked for in single precision: what that leaves in doubt is decided in double precision.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "nearest/local_features.h"
#include "nearest/nearest_feature.h"
#include "nearest/nearest_kernels.h"
#include "nearest/step_batch.h"

namespace meniscus {

/// Works on one group of points after the other, reusing its memory. Same as AccessibleSurface::nearest for every point
/// within a margin of the surface; of all others it says on which side they are.
class NearestBatch {
public:
    enum class Claim : std::uint8_t {
        Open,
        Below,  ///< signed distance <= -margin
        Above,  ///< signed distance >= margin
        Ball,
        Edge,  ///< arc or vertex
    };

    explicit NearestBatch(const AccessibleSurface& surface, const NearestKernels& kernels = nearest_kernels());
    ~NearestBatch();

    /// Begins with a box that `local` answers for, and a margin up to that of `local`. Below or Above if that holds for
    /// all its points: then there is nothing to find. Open otherwise.
    Claim start(const LocalFeatures& local, const Box& box, double margin);

    /// Finds what is nearest to points of that box, at most kBatchLanes.
    void find(std::span<const Vec3> points);
    /// The same without a copy of the points, which must stay until the next ones come.
    void find(const LanePoints<double>& points, std::size_t count);
    /// Then finds their mean curvatures.
    void find_curvatures();

    Claim claim(std::size_t point) const {
        const double s = signed_distance(point);
        if (s >= answers_.margin) return Claim::Above;
        if (answers_.claims.owned[answers_.lane_of[point]] != 0) return Claim::Ball;
        return s <= -answers_.margin ? Claim::Below : Claim::Edge;
    }
    /// Which side a point is on, unless it is nearer to the surface than the margin and that is less than rounding.
    bool is_inside(std::size_t point) const { return signed_distance(point) < 0.0; }
    bool found(std::size_t point) const { return claim(point) == Claim::Ball || claim(point) == Claim::Edge; }
    /// Writes the signed distance of every point, clamped to ±margin, to the place given for it, and the mean
    /// curvature, once they were found, clamped to ±limit, and 0 where the distance is clamped.
    void write(std::span<const std::uint32_t> places, double limit, float* distances, float* curvatures);
    /// Precondition of the others: found.
    double signed_distance(std::size_t point) const { return answers_.claims.signed_distance[answers_.lane_of[point]]; }
    /// Once curvatures were found.
    double mean_curvature(std::size_t point) const { return answers_.curvatures[answers_.lane_of[point]]; }
    FeatureCell nearest(std::size_t point) const;
    NearestFeature feature(std::size_t point) const;
    FeatureLabel label(std::size_t point) const;
    /// The nearest point of K. Not finite in the centre of a ball and on the axis of an arc.
    Vec3 foot(std::size_t point) const;
    /// A step along the distance to the surface.
    SurfaceStep step_to_surface(std::size_t point) const;
    /// The same for all points that were found; those of others lead nowhere and are not settled.
    void steps_to_surface(BatchSteps& steps);

private:
    // What was found; points are kept in lanes, those with the same deepest ball next to each other.
    struct Answers {
        double margin = 0.0;
        LaneArray<std::uint32_t> lane_of;  // per point; all others per lane
        BallClaims claims;                 // signed distances are those of all points in the end
        LaneArray<std::uint32_t> atoms;    // where a ball owns the point
        LaneArray<std::int64_t> tags;      // where none does
        LaneArray<double> curvatures;

        FeatureCell cell_of(std::size_t lane) const;
    };
    struct Search;

    Answers answers_;
    std::unique_ptr<Search> search_;
};

}  // namespace meniscus
