// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points near the surface to points on it, for whoever changes the mesh.
#pragma once

#include "meniscus/accessible_surface.h"
#include "meniscus/level_set.h"
#include "remesh/remesher.h"

namespace meniscus {

/// Onto the zero set of a level set, or, where that is null, onto the exact SES. Both must outlive the projector.
///
/// cost     0.3 to 0.5 µs per point, if neighbours come together
SurfaceProjector surface_projector(const AccessibleSurface& accessible, const LevelSet* level_set, double spacing);

}  // namespace meniscus
