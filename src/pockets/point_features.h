// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the ranking of pockets knows of a point: how deep it lies, and which atoms are around it.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/exact_surface.h"
#include "meniscus/pockets.h"
#include "pockets/pocket_space.h"

namespace meniscus {

/// The features, in the order of the model's table (pocket_model.h). Lengths in Å.
enum PointFeature : std::uint8_t {
    kNear6,  ///< number of atoms closer than 6 Å
    kNear8,
    kNear10,
    kAsymmetry6,  ///< how one-sided these atoms are, 0 to 1
    kAsymmetry10,
    kDepth2,       ///< below the SES of a probe of 2.0 Å; negative outside
    kDepth3,       ///< 3.3 Å
    kDepth4,       ///< 4.6 Å
    kDepth5,       ///< 5.5 Å
    kDepth10,      ///< of the large probe
    kNarrowShare,  ///< average of the space below the SES of 4.6 Å, sigma 1.5 Å
    kMediumShare,  ///< sigma 3 Å
    kWideShare,    ///< average of all pocket space, sigma 5 Å
    kNarrowDepth,  ///< average of depths, sigma 2 Å
    kWideDepth,    ///< sigma 4 Å
    kLimitedDepth10,
    kMediumShare2,  ///< the square of kMediumShare
    kClasses6,      ///< shares of the atom classes among the atoms closer than 6 Å; kAtomClasses of them
    kClasses10 = kClasses6 + kAtomClasses,
    kFeatureCount = kClasses10 + kAtomClasses,
};
static_assert(kFeatureCount == kPocketFeatures);
using PointFeatures = std::array<double, kFeatureCount>;

/// Of some voxels, which the ranking looks at: those in pocket space whose node no atom is closer to than 1 Å.
struct RankedPoints {
    std::vector<VoxelId> voxels;  ///< ascending
    std::vector<PointFeatures> features;
};

/// atoms     of both surfaces, for four more
/// classes   in the order of the atoms, or empty
/// cost      the four surfaces, and some 3 µs per voxel
RankedPoints rank_points(const PocketSpace& space, const AccessibleSurface& small, const Atoms& atoms,
                         std::span<const AtomClass> classes);

}  // namespace meniscus
