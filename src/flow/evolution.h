// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The level-set evolution that carries the Gaussian start to the solvent-excluded surface.
//
// One loop for all flows: reinitialise, one semi-implicit Euler step, measure the change. FlowOptions says with which
// curvature field, anchor, reinitialiser and solver.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "band/distance_band.h"
#include "grid/block_grid.h"
#include "meniscus/flow.h"
#include "meniscus/node_field.h"

namespace meniscus {

/// How wide the sampled band must be around the unknowns, in spacings: the spline's stencils reach two nodes.
inline constexpr double kBandRim = 2.0;
/// The same for a single solve with the usual half width at least, which damps what is wrong beyond
/// (docs/design/flow.md).
inline constexpr double kThinRim = 1.25;

/// Root mean square error of Φ that a solve leaves, in spacings.
inline constexpr double kSolverAccuracy = 2e-5;

/// Coefficients of the spline and its values at the nodes; outside the unknowns, values of what holds it there.
struct FlowState {
    NodeField coefficients;
    NodeField values;
};

struct EvolutionResult {
    FlowState state;
    int steps = 0;
    double time = 0.0;      ///< Å²
    double residual = 0.0;  ///< mean |ΔΦ|/τ over |Φ| < spacing at the last step, Å^-1
    FlowEnd end = FlowEnd::StepsUsedUp;
    int solver_iterations = 0;
    int reinitialisations = 0;

    bool converged() const { return end == FlowEnd::Converged; }
};

/// Called after every step with how far the flow is and the fraction of the way done; the state is the result's.
using EvolutionObserver = std::function<void(const EvolutionResult&, double fraction)>;

/// What a flow begins with.
struct FlowStart {
    DistanceBand
        band;  ///< s and H0 (FlowOptions::curvature), the latter within half_width + kBandRim spacings at least
    std::span<const float> start{};  ///< Φ at the nodes, Å; s if it is empty
};

/// Runs a flow.
///
/// source   Pan & Tai 2009, eqs. 2.4, 3.3-3.5, with the changes of docs/design/flow.md
EvolutionResult evolve(const BlockGrid& grid, FlowStart from, const FlowOptions& options,
                       const EvolutionObserver& observer);

/// Coefficients of the spline that takes `values` at the nodes where |value| < half_width spacings.
NodeField interpolating_coefficients(const BlockGrid& grid, std::span<const float> values, double half_width);

/// Half the discrete Laplacian of the spline through the distance, where |s| < half_width spacings: what
/// CurvatureField::Sharp is; `curvature` elsewhere.
NodeField sharp_curvature(const BlockGrid& grid, const DistanceBand& band, double half_width);

}  // namespace meniscus
