// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How far the triangles of a mesh are from the exact surface, as measure_distance() has it, without the rest of that.
#pragma once

#include <cstddef>

#include "meniscus/accessible_surface.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// Mean distance to the exact SES, by area, Å, told from every `step`-th triangle; 0 without triangles.
///
/// cost  0.8 µs per triangle looked at, parallel
double mean_distance_to_exact(const Mesh& mesh, const AccessibleSurface& surface, std::size_t step);

}  // namespace meniscus
