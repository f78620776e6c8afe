// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface as values on a regular grid: distance, mask, dielectric constant, accessibility for ions.
#pragma once

#include <cstddef>

#include "meniscus/surface.h"
#include "meniscus/volume.h"

namespace meniscus {

struct FieldOptions {
    VolumeContent content = VolumeContent::Distance;
    double inner_dielectric = 2.0;
    double outer_dielectric = 78.54;  ///< water at 25 °C
    double ion_radius = 2.0;          ///< Å
    int threads = 0;                  ///< 0: all cores; the values do not depend on it
};

/// The grid that a surface's field is put on where no other is asked for: nodes at multiples of the spacing, from at
/// least kFieldMargin spacings before the box round all balls of the exact surface, to as many behind it.
///
/// throws   std::invalid_argument for no atoms
VolumeGrid enclosing_grid(const ExactSurface& exact, double spacing);
inline constexpr double kFieldMargin = 4.0;

/// The value at each node of a grid:
///
/// Distance    Å, positive inside, so that contours at 0 have outward normals where programs take gradients downhill.
///             Within the inner part of the narrow band it is the level set, so that the zero set is that of the
///             surface; beyond it the exact signed distance to the SES. Without an anchor to the SES (Method::Gaussian,
///             flows without anchor) it is the level set in the whole band and beyond it that distance with the level
///             set's sign, at least half the band's width. Method::Direct: the exact distance everywhere
/// Mask        1 inside, 0 outside
/// Dielectric  the inner or outer one, by the side the node lies on
/// Ions        0 in the atoms enlarged by the ion radius, 1 elsewhere; the surface has no part in it
///
/// Inside are nodes with a distance above 0. Cavities are outside, whichever pieces the mesh keeps, but for those that
/// SurfaceOptions::fill_cavities has filled: they are inside, and no ion reaches them.
///
/// throws   UsageError for a grid without nodes or with spacings that are not positive, for dielectric constants that
///          are not positive, an ion radius or a number of threads that is negative, and for any of these or an origin
///          that is not finite; LimitError for a grid that memory has no room for
/// cost     0.02 (sides) to 0.1 µs (distances) of processor time per node; level sets without
///          an anchor take about 1 µs
Volume surface_field(const Surface& surface, const VolumeGrid& grid, const FieldOptions& options = {});

/// The four maps that APBS takes in place of its own: dielectric constants half a spacing beside the nodes along x, y
/// and z, and accessibility for ions at the nodes.
enum class ApbsMap { DielectricX, DielectricY, DielectricZ, Kappa };

constexpr VolumeContent content_of(ApbsMap map) {
    return map == ApbsMap::Kappa ? VolumeContent::Ions : VolumeContent::Dielectric;
}

/// One of them, for APBS's grid.
/// options   content is not used
/// throws    as surface_field
Volume apbs_map(const Surface& surface, const VolumeGrid& grid, ApbsMap map, const FieldOptions& options = {});

/// Throws LimitError with the numbers where `volumes` of this grid beside the surface's computation are expected to
/// take more memory than is allowed, or than the machine has left if that is 0.
void refuse_grid_that_would_not_fit(const VolumeGrid& grid, std::size_t volumes, const Cost& cost,
                                    std::size_t memory_limit_mb = 0);

}  // namespace meniscus
