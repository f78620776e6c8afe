// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which voxels lie in closed cavities.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/exact_surface.h"
#include "pockets/pocket_space.h"

namespace meniscus {

/// For each voxel the index of its cavity among the components of exact.measures(), or kNone.
///
/// exact   the SES of the small probe
std::vector<std::uint32_t> cavity_voxels(const PocketSpace& space, const ExactSurface& exact);

}  // namespace meniscus
