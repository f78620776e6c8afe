// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The exact signed distance and the curvature of its level surfaces, sampled on the nodes of the band.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/local_features.h"
#include "geometry/nearest_batch.h"
#include "geometry/nearest_kernels.h"
#include "grid/block_grid.h"
#include "meniscus/accessible_surface.h"
#include "meniscus/node_field.h"

namespace meniscus {

/// What to sample. Without the curvature it is a little quicker.
enum class BandFields : std::uint8_t { Distance, DistanceAndCurvature };

/// One entry per node of the grid.
struct DistanceBand {
    double margin = 0.0;  ///< Å
    NodeField distance;   ///< signed distance to the SES, clamped to ±margin, Å
    NodeField curvature;  ///< mean curvature of the parallel surface, clamped to ±1/spacing, Å^-1;
                          ///< 0 where the distance is clamped; empty if not asked for
};

/// Samples every node of the grid.
///
/// cost     parallel over blocks
DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin,
                             BandFields fields = BandFields::DistanceAndCurvature);

/// Where the samples of one block go. curvature: empty, or one entry per node.
struct BlockSamples {
    std::span<float, kBlockNodes> distance;
    std::span<float> curvature;
};

/// Evaluates all nodes of one block after the other, reusing its memory.
class BlockDistance {
public:
    BlockDistance(const AccessibleSurface& surface, double spacing, double margin);

    /// Goes to a box, then to a part of it, whose blocks will be evaluated.
    void enter(const Box& box) { around_.gather(box); }
    void enter_part(const Box& box) { part_.gather_from(around_, box); }

    /// corner: position of node (0, 0, 0)
    void evaluate(const Vec3& corner, const BlockSamples& samples);

    // As many nodes as the batch takes at once; two along each axis make up a block.
    static constexpr int kUnitEdge = kBlockEdge / 2;
    static constexpr int kUnitNodes = kUnitEdge * kUnitEdge * kUnitEdge;
    static constexpr int kUnits = kBlockNodes / kUnitNodes;

private:
    using Claim = NearestBatch::Claim;

    static constexpr double kNever = -1.0;  // no squared distance is below

    // What is known of a unit from its middle.
    struct Middle {
        Claim side = Claim::Open;  // Below and Above are for all nodes of the unit
        double distance = 0.0;     // signed, Å
        Vec3 to_foot;              // nearest point of K
    };

    void screen_units(const Vec3& corner);
    void evaluate_unit(int unit, const Vec3& corner, const BlockSamples& samples);
    void fill_unit(int unit, Claim side, const BlockSamples& samples) const;
    void screen_nodes(const Middle& middle);
    void choose_points(const Vec3& corner);
    void sample_points();
    void write_unit(int unit, const BlockSamples& samples) const;

    double spacing_;
    double margin_;
    double half_unit_;            // Å: half a unit's diagonal
    double slack_;                // Å: more than all that single precision gets wrong
    double near_foot2_ = kNever;  // Å²: of nodes so near to a point of K that they are above the margin
    bool curved_ = false;         // whether the curvature is asked for
    LocalFeatures around_;        // of many blocks
    LocalFeatures part_;          // of fewer of them
    LocalFeatures block_;
    NearestBatch batch_;
    const NearestKernels& kernels_ = nearest_kernels();
    Middle middles_[kUnits];

    LanePoints<double> offsets_;    // of the unit's nodes from its first
    LanePoints<float> steps_;       // of the same from the unit's middle
    LaneArray<float> from_middle_;  // Å: how long these are
    float distances_[kUnitNodes];   // of the unit's nodes
    float curvatures_[kUnitNodes];
    LaneArray<std::int32_t> within_;   // whether a node may be within the margin
    std::uint32_t nodes_[kUnitNodes];  // those that may
    std::size_t count_ = 0;            // how many they are
    LanePoints<double> points_;        // where they are
};

}  // namespace meniscus
