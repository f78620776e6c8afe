// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The curvature field of the paper as printed, which is constant along the normals of the SES.
#pragma once

#include <vector>

#include "geometry/accessible_surface.h"
#include "grid/block_grid.h"
#include "meniscus/node_field.h"

namespace meniscus {

/// What stands for two atoms that a probe touches but that do not intersect themselves.
enum class BridgedPair {
    Torus,      ///< the formula of intersecting atoms
    Reentrant,  ///< -1/R, a literal reading
};

/// H0 at every node from the nearest point of the SES, Å^-1: 1/r on contact patches, -1/R on reentrant ones, and
/// (1/d - 1/R)/2 on toroidal ones, d the distance of that point from the line through the two centres. The printed
/// torus lacks a cosine, and away from the SES no level surface has this curvature. Clamped to ±1/spacing.
///
/// cost     O(log n) per node, parallel
/// source   Pan & Tai 2009, section 3
NodeField sample_printed_curvature(const AccessibleSurface& surface, const BlockGrid& grid, BridgedPair bridged);

}  // namespace meniscus
