// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// On which side of the exact SES the nodes of the band are: all that marching cubes needs of it.
#pragma once

#include <vector>

#include "geometry/accessible_surface.h"
#include "grid/block_grid.h"
#include "grid/inside_bits.h"

namespace meniscus {

/// Which nodes of each block of the grid have a negative signed distance.
///
/// cost     parallel over blocks
std::vector<InsideBits> find_sides(const AccessibleSurface& surface, const BlockGrid& grid);

}  // namespace meniscus
