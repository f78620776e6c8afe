// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Totals of one evaluation without its patches: what a second evaluation is asked for.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/accessible_surface.h"
#include "meniscus/measures.h"

namespace meniscus {

struct PatchTotals {
    SurfaceTotals totals;
    bool degenerate = false;
    std::vector<std::uint32_t> unresolved;  ///< vertices whose trimming could not be resolved
};

/// Sums over all patches; keeps none of them and does not ask which pieces of surface they make.
PatchTotals sum_patches(const AccessibleSurface& surface, std::uint64_t seed);

}  // namespace meniscus
