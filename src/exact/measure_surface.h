// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Exact measures of an accessible surface that is there already.
#pragma once

#include "geometry/accessible_surface.h"
#include "meniscus/atoms.h"
#include "meniscus/measures.h"

namespace meniscus {

/// What measure() of the atoms finds; the options' probe radius does not matter.
///
/// surface   of these atoms
Measures measure(const AccessibleSurface& surface, const Atoms& atoms, const MeasureOptions& options = {});

/// What measure() finds with cavities, from a single evaluation: `errors` are zero, and `agreed` only tells whether
/// every patch could be resolved.
///
/// surface   of these atoms
/// cost      a third of measure()
Measures measure_once(const AccessibleSurface& surface, const Atoms& atoms);

}  // namespace meniscus
