// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The steady state of an anchored flow in one solve: the default, in as little memory as it can do with.
#pragma once

#include "band/distance_band.h"
#include "flow/evolution.h"
#include "grid/block_grid.h"
#include "meniscus/flow.h"

namespace meniscus {

/// Whether a flow is one solve and its result does not depend on the start: an infinite time step, a slope of 1 and no
/// reinitialiser.
bool is_one_solve(const FlowOptions& options);

/// Solves (λB - L) d = λ s - 2 H0, on the nodes with |s| < half_width spacings; the others keep s. What evolve() does
/// for such a flow, without copies: the band's fields become the values and the right side.
///
/// options    with is_one_solve()
/// band       with a margin of half_width + kThinRim spacings at least
EvolutionResult solve_steady_state(const BlockGrid& grid, DistanceBand band, const FlowOptions& options);

}  // namespace meniscus
