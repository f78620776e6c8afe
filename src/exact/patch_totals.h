// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Totals of one evaluation without its patches, and how they are divided among the pieces that another evaluation
// found: what a second evaluation is asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/ses_patches.h"
#include "geometry/accessible_surface.h"
#include "meniscus/measures.h"

namespace meniscus {

struct PatchTotals {
    SurfaceTotals totals;
    std::vector<SurfaceTotals> components;  ///< numbered as in the evaluation asked about
    bool degenerate = false;
    std::vector<std::uint32_t> unresolved;  ///< vertices whose trimming could not be resolved
};

/// Adds the area of a patch, Å², to that of its kind.
template <class Areas>
void add_area(Areas& to, PatchKind kind, double area) {
    if (kind == PatchKind::Contact) to.contact_area += area;
    if (kind == PatchKind::Toroidal) to.toroidal_area += area;
    if (kind == PatchKind::Reentrant) to.reentrant_area += area;
}

/// Sums over all patches; keeps none of them and does not ask which pieces of surface they make.
///
/// Each patch is counted to that component of `first`, an evaluation of the same atoms, to which the matching patch
/// belongs. A patch without a match is counted to the largest component: then the estimated errors are large. Without a
/// first evaluation all patches count to one component.
PatchTotals sum_patches(const AccessibleSurface& surface, std::uint64_t seed, const SesPatches* first = nullptr);

}  // namespace meniscus
