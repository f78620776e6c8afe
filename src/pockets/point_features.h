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
    Near6,  ///< number of atoms closer than 6 Å
    Near8,
    Near10,
    Asymmetry6,  ///< how one-sided these atoms are, 0 to 1
    Asymmetry10,
    Depth2,       ///< below the SES of a probe of 2.0 Å; negative outside
    Depth3,       ///< 3.3 Å
    Depth4,       ///< 4.6 Å
    Depth5,       ///< 5.5 Å
    Depth10,      ///< of the large probe
    NarrowShare,  ///< average of the space below the SES of 4.6 Å, sigma 1.5 Å
    MediumShare,  ///< sigma 3 Å
    WideShare,    ///< average of all pocket space, sigma 5 Å
    NarrowDepth,  ///< average of depths, sigma 2 Å
    WideDepth,    ///< sigma 4 Å
    LimitedDepth10,
    MediumShare2,  ///< the square of MediumShare
    Classes6,      ///< shares of the atom classes among the atoms closer than 6 Å; kAtomClasses of them
    Classes10 = Classes6 + kAtomClasses,
    FeatureCount = Classes10 + kAtomClasses,
};
static_assert(FeatureCount == kPocketFeatures);
using PointFeatures = std::array<double, FeatureCount>;

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
