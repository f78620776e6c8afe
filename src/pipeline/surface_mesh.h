// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From node values to a labelled mesh whose vertices lie on the surface, and how far that is from the exact one.
#pragma once

#include <span>

#include "grid/block_grid.h"
#include "meniscus/accessible_surface.h"
#include "meniscus/level_set.h"
#include "meniscus/mesh.h"
#include "meniscus/surface.h"

namespace meniscus {

struct SurfaceMesh {
    Mesh mesh;
    DistanceSummary distance;
};

/// pieces      what is kept of the zero set
/// level_set   whose values at the nodes `values` are: vertices are projected onto its zero set; null: onto the exact
/// SES
SurfaceMesh mesh_surface(const AccessibleSurface& accessible, const BlockGrid& grid, std::span<const float> values,
                         const LevelSet* level_set, Pieces pieces);

}  // namespace meniscus
