// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The exact signed distance and the curvature of its level surfaces, sampled on the nodes of the band.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geometry/local_features.h"
#include "grid/block_grid.h"
#include "meniscus/accessible_surface.h"

namespace meniscus {

/// One entry per node of the grid.
struct DistanceBand {
    double margin = 0.0;           ///< Å
    std::vector<float> distance;   ///< signed distance to the SES, clamped to ±margin, Å
    std::vector<float> curvature;  ///< mean curvature of the parallel surface, clamped to ±1/spacing, Å^-1;
                                   ///< 0 where the distance is clamped
};

/// Samples every node of the grid.
///
/// cost     parallel over blocks
DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin);

/// Evaluates all nodes of one block after the other, reusing its memory.
class BlockDistance {
public:
    BlockDistance(const AccessibleSurface& surface, double spacing, double margin);

    /// corner: position of node (0, 0, 0)
    void evaluate(const Vec3& corner, std::span<float, kBlockNodes> distance, std::span<float, kBlockNodes> curvature);

private:
    struct NodeRange {
        int begin[3];
        int end[3];
    };
    struct Sample {
        double distance;
        double curvature;
    };

    Vec3 position(int node) const;
    NodeRange nodes_in(const Box& box) const;
    void find_deepest_balls();
    void claim_by_balls();
    void offer_arcs();
    void offer_vertices();
    Sample sample(int node) const;

    enum class Claim : std::uint8_t { Open, Ball, Deep, Arc };
    alignas(64) double depth_[kBlockNodes];
    alignas(64) std::int64_t ball_[kBlockNodes];      // position in local_.balls(), as wide as depth_ to vectorise
    alignas(64) double squared_vertex_[kBlockNodes];  // distance² of the nearest vertex
    double squared_arc_[kBlockNodes];                 // and of the nearest arc
    std::uint32_t arc_[kBlockNodes];
    Claim claim_[kBlockNodes];

    const AccessibleSurface* surface_;
    const AccessibleSurface::Data* data_;
    LocalFeatures local_;
    double spacing_;
    double margin_;
    Vec3 corner_;
    int open_ = 0;
};

}  // namespace meniscus
