// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the exact geometry says that a result is held against.
#pragma once

#include <vector>

#include "exact/piece_points.h"
#include "meniscus/measures.h"
#include "meniscus/surface.h"

namespace meniscus {

/// A piece of the surface with a larger inscribed radius must be there.
inline constexpr double kResolved = 1.5;  // spacings

struct ReferenceValues {
    SurfaceTotals kept;             ///< exact area and volume of what the mesh keeps
    double doubtful = 0.0;          ///< Å³ of pieces that the mesh may have or not
    std::vector<DeepPoint> points;  ///< whose sides are told by the exact geometry, with radii that are resolved
    bool resolved = true;           ///< the exact volume could be found
    double sharpest = 1.0;          ///< Å: radius of the smallest atom, at most 1 and at least the spacing
};

/// From exact measures of all pieces.
///
/// atoms     of the surface's ses_problem()
/// measured  of these, with cavities
ReferenceValues reference_values_of(const Measures& measured, const Atoms& atoms, const SurfaceOptions& options);

/// From the exact surface. Where the mesh keeps every piece and the probe is resolved by the grid the pieces need not
/// be known: only sums are evaluated (docs/design/self-checks.md).
ReferenceValues find_reference_values(const AccessibleSurface& accessible, const Atoms& atoms,
                                      const SurfaceOptions& options);

/// Points of the box round the atoms that are farther than resolved from the surface, with their sides: evenly spread,
/// always the same.
std::vector<DeepPoint> scattered_points(const AccessibleSurface& accessible, const SurfaceOptions& options);

}  // namespace meniscus
