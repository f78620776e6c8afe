// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// On which side of the SES points are, in single precision, for several instruction sets. What rounding leaves in doubt
// stays open: what is settled is true, and so the same for every set.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "band/side_features.h"
#include "nearest/nearest_kernels.h"

namespace meniscus {

/// A cube that holds points, relative to the middle of a box around it.
struct SideCube {
    SmallVec3 middle;
    float half_edge = 0.0F;  ///< Å
};

/// Points nearer to K than `near` are outside, those farther from it than `far` inside: in K distances are negative.
struct SideLimits {
    float near;           ///< Å
    float far;            ///< Å
    float reach;          ///< Å: of the points from their middle
    float slack;          ///< Å: more than all that rounding gets wrong of a length
    float squared_slack;  ///< Å²: the same of what may_be_deeper holds against each other (side_kernels.inc)

    /// Where what is within `radius` of a point is to have its side. longest: no length that decides is longer. Å
    SideLimits(double probe, double radius, double reach_of_points, double longest);
};

/// What settling works with.
struct SideWork {
    LaneArray<float> depths;
    LaneArray<std::int32_t> deepest;  ///< the number of the ball where a point is deepest
    // Of the points that depths and vertices leave open, ball by ball.
    LanePoints<float> open_points;
    LaneArray<float> open_depths;
    std::uint32_t numbers[kBatchLanes];
    std::vector<std::uint32_t> caps;  ///< of one ball, those that decide between points
};

struct SideKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"

    /// Chooses the features that can be nearest to points of a cube, relative to its middle. deepest: the number of a
    /// ball; the deeper it is in the cube, the fewer are chosen.
    void (*choose)(const SideFeaturesOfBox& from, const SideCube& cube, const SideLimits& limits, std::size_t deepest,
                   SideFeatures& chosen);

    /// Which of up to kBatchLanes points are settled. There must be a ball.
    KnownSides (*settle)(const SideCaps& caps, const SideFeatures& features, const SideLimits& limits,
                         const LanePoints<float>& points, std::size_t count, SideWork& work);
};

/// Those that this machine can run, the plainest first.
std::vector<SideKernels> supported_side_kernels();

/// Those with the instructions that the environment variable MENISCUS_INSTRUCTIONS names, else the last ones; the same
/// from the first call to the end of the program.
const SideKernels& side_kernels();

}  // namespace meniscus
