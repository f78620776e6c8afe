// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The few triangles with small angles that remain, one by one.
#pragma once

#include "remesh/working_mesh.h"

namespace meniscus {

/// Flips, collapses and moves vertices, in this order, until no angle is below 30 degrees or nothing helps.
void mend_angles(WorkingMesh& mesh, const SurfaceProjector& project);

}  // namespace meniscus
