// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface as values on a regular grid: distance, mask, dielectric constant, accessibility for ions.
#pragma once

#include <cstddef>

#include "meniscus/surface.h"
#include "meniscus/volume.h"

namespace meniscus {

/// What a field holds, and the numbers it is made with.
struct FieldOptions {
    VolumeContent content = VolumeContent::Distance;
    double inner_dielectric = 2.0;    ///< relative permittivity, > 0
    double outer_dielectric = 78.54;  ///< relative permittivity, > 0: water at 25 °C
    double ion_radius = 2.0;          ///< Å, >= 0
    int threads = 0;                  ///< 0: all cores; the values do not depend on it
};

/// The default grid for a field of a surface: nodes at multiples of the spacing (Å), which reach at least kFieldMargin
/// spacings beyond the bounding box of all balls of the exact surface, on every side.
///
/// throws   std::invalid_argument for no atoms
VolumeGrid enclosing_grid(const ExactSurface& exact, double spacing);
inline constexpr double kFieldMargin = 4.0;  ///< spacings

/// The value at each node of a grid:
///
/// Distance    signed distance to the surface, Å, positive inside: contours at 0 get outward normals from programs that
///             take gradients downhill. With Method::Direct the exact distance everywhere; else the level set in the
///             inner part of the narrow band, so that its zero set is that of the field, and beyond the exact distance.
///             Without an anchor (Method::Gaussian, some flows) the level set in the whole band; beyond, the exact
///             distance with the sign of the level set, and at least half the width of the band
/// Mask        1 inside, 0 outside
/// Dielectric  FieldOptions::inner_dielectric inside, outer_dielectric outside
/// Ions        0 in the atoms enlarged by the ion radius, 1 elsewhere, wherever the surface is
///
/// Nodes with a distance above 0 are inside. Cavities are outside, whichever pieces the mesh keeps; only cavities that
/// SurfaceOptions::fill_cavities has filled are inside, and no ion reaches them.
///
/// throws   UsageError for a grid without nodes, spacings or dielectric constants that are not positive, an ion radius
///          or a number of threads that is negative, and for numbers that are not finite; LimitError for a grid that
///          does not fit into memory
/// cost     per node 0.1 µs of processor time for distances, 0.02 µs for the others, about 1 µs without an anchor
Volume surface_field(const Surface& surface, const VolumeGrid& grid, const FieldOptions& options = {});

/// The four maps that APBS can read instead of computing them: dielectric constants half a spacing beyond each node
/// along x, y or z, and accessibility for ions at the nodes.
enum class ApbsMap { DielectricX, DielectricY, DielectricZ, Kappa };

/// What the values of a map mean.
constexpr VolumeContent content_of(ApbsMap map) {
    return map == ApbsMap::Kappa ? VolumeContent::Ions : VolumeContent::Dielectric;
}

/// Computes a map for APBS.
///
/// grid      that of APBS, without the shift by half a spacing
/// options   `content` is not used
/// throws    as surface_field()
Volume apbs_map(const Surface& surface, const VolumeGrid& grid, ApbsMap map, const FieldOptions& options = {});

/// Throws a LimitError that gives the numbers if `volumes` volumes on a grid, together with the computation of the
/// surface, are expected to exceed a limit of memory (units of 2^20 bytes; 0: what the machine has left).
void refuse_grid_that_would_not_fit(const VolumeGrid& grid, std::size_t volumes, const Cost& cost,
                                    std::size_t memory_limit_mb = 0);

}  // namespace meniscus
