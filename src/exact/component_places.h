// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the pieces of the SES lie: which is inside which, and the largest sphere that fits a cavity.
#pragma once

#include <span>
#include <vector>

#include "exact/ses_patches.h"
#include "meniscus/measures.h"

namespace meniscus {

/// For each component, the one next outside, or kNone; volumes: signed, one per component.
///
/// Counts how often a straight way out of each piece crosses the others; sphere tracing with the exact distance.
/// cost     O(pieces · way), only where there is more than one outer piece
std::vector<std::uint32_t> nest_components(const AccessibleSurface& surface, const SesPatches& patches,
                                           std::span<const double> volumes);

struct InscribedSphere {
    Vec3 centre;
    double radius = 0.0;  ///< Å
};

/// The largest sphere inside the solvent that touches no atom, reached by ascent from probe positions `starts` on
/// the walls of one cavity. Its centre stays in `room`, a box round the atoms of
/// these walls, and passes through no atom on its way: walls without thickness, as of spheres of which four meet in a
/// point, hold it.
InscribedSphere largest_inscribed_sphere(const AccessibleSurface& surface, std::span<const Vec3> starts,
                                         const Box& room);

}  // namespace meniscus
