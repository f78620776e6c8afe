// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The exact signed distance and the curvature of its level surfaces, sampled on the nodes of the band.
#pragma once

#include "geometry/accessible_surface.h"
#include "grid/block_grid.h"
#include "meniscus/node_field.h"

namespace meniscus {

/// One entry per node of the grid.
struct DistanceBand {
    double margin = 0.0;  ///< Å
    NodeField distance;   ///< signed distance to the SES, clamped to ±margin, Å
    NodeField curvature;  ///< mean curvature of the parallel surface, clamped to ±1/spacing, Å^-1;
                          ///< 0 where the distance is clamped
};

/// Samples every node of the grid.
///
/// cost     parallel over blocks
DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin);

}  // namespace meniscus
