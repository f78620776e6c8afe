// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The nearest features of up to 64 neighbouring points at once.
//
// Whose a point is follows from the same tests as in nearest_feature.h, with the points as the lanes of vectors. Only
// the deepest ball is looked for in single precision: what that leaves in doubt is decided in double precision.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

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

    explicit NearestBatch(const AccessibleSurface& surface, const NearestKernels& kernels = nearest_kernels())
        : data_(&surface.data()), kernels_(kernels), stepper_(surface, kernels) {}
    NearestBatch(const NearestBatch&) = delete;  // it may point to its own points
    NearestBatch& operator=(const NearestBatch&) = delete;

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
        const std::size_t lane = lane_of_[point];
        const double s = claims_.signed_distance[lane];
        if (s >= margin_) return Claim::Above;
        if (claims_.owned[lane] != 0) return Claim::Ball;
        return s <= -margin_ ? Claim::Below : Claim::Edge;
    }
    /// Which side a point is on, unless it is nearer to the surface than the margin and that is less than rounding.
    bool is_inside(std::size_t point) const { return claims_.signed_distance[lane_of_[point]] < 0.0; }
    bool found(std::size_t point) const { return claim(point) == Claim::Ball || claim(point) == Claim::Edge; }
    /// Writes the signed distance of every point, clamped to ±margin, to the place given for it, and the mean
    /// curvature, once they were found, clamped to ±limit, and 0 where the distance is clamped.
    void write(std::span<const std::uint32_t> places, double limit, float* distances, float* curvatures);
    /// Precondition of the others: found.
    double signed_distance(std::size_t point) const { return claims_.signed_distance[lane_of_[point]]; }
    double mean_curvature(std::size_t point) const { return curvatures_[lane_of_[point]]; }  ///< once they were found
    FeatureCell nearest(std::size_t point) const { return cell_of(lane_of_[point]); }
    NearestFeature feature(std::size_t point) const {
        return feature_in(*data_, get_point(*points_, point), nearest(point));
    }
    FeatureLabel label(std::size_t point) const;
    /// The nearest point of K. Not finite in the centre of a ball and on the axis of an arc.
    Vec3 foot(std::size_t point) const;
    /// A step along the distance to the surface.
    SurfaceStep step_to_surface(std::size_t point) const;
    /// The same for all points that were found; those of others lead nowhere and are not settled.
    void steps_to_surface(BatchSteps& steps);

private:
    FeatureCell cell_of(std::size_t lane) const;
    void choose_contenders(std::size_t deepest);
    void load();
    void group_points();
    void sort_by_groups();
    LaneRange lanes_of(std::size_t group) const;
    std::size_t deepest_exactly(const Vec3& point) const;
    void claim_by_groups();
    void claim_by_side(double signed_distance, const LaneRange& lanes);
    void claim_by_ball(std::size_t contender, const LaneRange& lanes);
    void collect_open();
    void offer_edges();
    void choose_edges();
    void drop_above();
    void claim_by_edges();

    const AccessibleSurface::Data* data_;
    NearestKernels kernels_;
    const LocalFeatures* local_ = nullptr;

    double margin_ = 0.0;
    double beyond_ = 0.0;  // Å by which points within the margin may be outside of all balls
    Box box_;
    Vec3 middle_;
    double half_diagonal_ = 0.0;
    double depth_error_ = 0.0;              // Å, of depths in single precision
    std::vector<double> depths_in_middle_;  // per ball of the lists
    std::vector<std::uint64_t> marks_;      // of a list: the features that may matter to the box
    SphereList contenders_;                 // balls that may be the deepest somewhere in the box
    std::vector<SmallBall> small_;          // the same
    std::vector<std::uint32_t> vertices_;   // positions in the lists' vertices
    std::vector<std::uint32_t> arcs_;

    const LanePoints<double>* points_ = &given_;
    std::size_t count_ = 0;
    LanePoints<double> given_;  // points that came one by one
    LanePoints<float> small_points_;
    Depths depths_;
    LaneArray<std::int32_t> groups_;    // per point
    std::vector<std::uint32_t> ends_;   // per group and chain: where its lanes end
    LaneArray<std::uint32_t> sorted_;   // points in the order of their groups: that of the lanes
    LaneArray<std::uint32_t> lane_of_;  // per point

    // Per lane.
    LanePoints<double> lanes_;  // the points
    BallClaims claims_;         // signed distances are those of all points in the end
    LaneArray<std::uint32_t> atoms_;
    LaneArray<std::int64_t> tags_;
    LaneArray<double> curvatures_;
    LaneArray<float> clamped_;
    LaneArray<float> clamped_curvatures_;

    std::size_t open_count_ = 0;
    LaneArray<std::uint32_t> open_;  // lanes that no ball owns
    LanePoints<double> open_points_;
    NearestTags nearest_;
    LaneArray<double> edge_distances_;
    LaneArray<double> edge_curvatures_;
    StepBatch stepper_;
    std::vector<std::uint32_t> others_;  // lanes that do not step with the others
};

}  // namespace meniscus
