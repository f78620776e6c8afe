// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From places that the caller names to regions of pocket space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/pockets.h"
#include "pockets/pocket_space.h"

namespace meniscus {

/// For each voxel the number of its place, or kNone. A voxel within reach of several places goes to the one with the
/// nearest point. Of the connected parts of what a place gets, those count that hold one of its points, or else the
/// largest; where such parts are closed cavities and open space, only the open space.
///
/// cavities   for each voxel the number of its closed cavity, or kNone
std::vector<std::uint32_t> place_regions(const PocketSpace& space, std::span<const PocketPlace> places,
                                         std::span<const std::uint32_t> cavities);

}  // namespace meniscus
