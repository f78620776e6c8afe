// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The level-set evolution that carries the Gaussian start to the solvent-excluded surface.
//
// Anchored mean-curvature flow, Φ_t = ΔΦ - 2 H_par |∇Φ| + λ(s - Φ): the paper's equation (2.4) with the curvature
// of the parallel surface and a term that holds Φ to the signed distance s, without which the SES is not a
// stable steady state (docs/design/flow.md).
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "band/distance_band.h"
#include "grid/block_grid.h"

namespace meniscus {

struct EvolutionOptions {
    double half_width = 3.0;  ///< k: unknowns are the nodes with |Φ| or |s| below k spacings
    double time_step = 16.0;  ///< τ, in units of spacing²; the anchor keeps the system well conditioned
    double anchor = 16.0;     ///< λ, in units of spacing^-2
    double tolerance = 1e-4;  ///< stop when residual / λ is below it, in spacings
    int max_steps = 30;
};

/// How wide the sampled band must be around the unknowns, in spacings: the spline's stencils reach two nodes.
inline constexpr double kBandRim = 2.0;

struct EvolutionResult {
    std::vector<float> coefficients;  ///< of the tri-cubic B-spline
    std::vector<float> values;        ///< of the spline at the nodes
    int steps = 0;
    double time = 0.0;      ///< Å²
    double residual = 0.0;  ///< mean |ΔΦ|/τ over |Φ| < spacing at the last step, Å^-1
    bool converged = false;
    int solver_iterations = 0;
};

/// Runs the anchored flow from `start`, node values of Φ, until it is steady.
///
/// band     sampled with margin (half_width + kBandRim) spacings on the same grid
/// step     called after every step with the fraction done, may be empty
/// source   Pan & Tai 2009, eqs. 2.4, 3.3-3.5, with the changes of docs/design/flow.md
EvolutionResult evolve_anchored(const BlockGrid& grid, const DistanceBand& band, std::span<const float> start,
                                const EvolutionOptions& options, const std::function<void(double)>& step);

/// Coefficients of the spline that takes `values` at the nodes where |value| < half_width spacings.
std::vector<float> interpolating_coefficients(const BlockGrid& grid, std::span<const float> values, double half_width);

}  // namespace meniscus
