// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The nodes of one block after the other in units, and what the middle of each unit tells of its nodes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "geometry/accessible_surface.h"
#include "grid/block_grid.h"
#include "grid/inside_bits.h"
#include "nearest/local_features.h"
#include "nearest/nearest_batch.h"
#include "nearest/nearest_kernels.h"

namespace meniscus {

/// Goes to blocks, and then to units of each, reusing its memory.
class BlockUnits {
public:
    using Claim = NearestBatch::Claim;

    /// margin  Å: up to this distance from the surface nodes have a distance
    BlockUnits(const AccessibleSurface& surface, double spacing, double margin);

    /// Up to which distance from the surface features must be gathered, Å.
    static double reach(double spacing, double margin);

    /// around: features for a box around the block; corner: position of node (0, 0, 0)
    void enter_block(const LocalFeatures& around, const Vec3& corner);

    /// Below or Above if that holds for all nodes of the unit. Open otherwise: then it may be searched.
    Claim enter_unit(int unit);

    // Of the unit that was entered last, nodes in the order of node_in_unit.

    /// Which nodes are known to be beyond the margin, and on which side: by the change of the distance from the unit's
    /// middle, and by the middle's foot, which is a point of K.
    KnownSides screen() const;
    /// Looks for what is nearest to some nodes, at most kUnitNodes.
    void search(std::span<const std::uint32_t> nodes);
    NearestBatch& batch() { return batch_; }  ///< of these nodes

private:
    // What is known of a unit from its middle.
    struct Middle {
        Claim side = Claim::Open;  // Below and Above are for all nodes of the unit
        double distance = 0.0;     // signed, Å
        Vec3 to_foot;              // nearest point of K
    };

    // What tells that nodes are beyond the margin.
    struct Limits {
        double margin;
        double slack;             // Å: more than all that single precision gets wrong
        float near_foot = -1.0F;  // Å²: nodes so near to a point of K are outside, beyond the margin
    };
    // The nodes of any unit.
    struct UnitNodes {
        LanePoints<double> offsets;     // from the first one
        LanePoints<float> from_middle;  // from the unit's middle
        LaneArray<float> lengths;       // of these
    };
    // Where the block and the unit are that were entered last.
    struct Entered {
        Vec3 corner;  // of the block
        Middle middles[kUnits];
        std::size_t unit = 0;
    };

    double spacing_;
    Limits limits_;
    UnitNodes nodes_;
    LocalFeatures block_;
    NearestBatch batch_;
    Entered entered_;
    LanePoints<double> points_;  // that are searched
};

}  // namespace meniscus
