// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The flows that carry a level set from the Gaussian map to the solvent-excluded surface, in parts that combine.
//
// All flows solve Φ_t = ΔΦ - 2 H0 |∇Φ| + λ(s - Φ) by semi-implicit Euler steps on a tri-cubic B-spline (Pan & Tai 2009,
// eqs. 2.4 and 3.3); s is the exact signed distance, Å, negative inside. docs/design/flow.md compares them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "meniscus/mesh.h"

namespace meniscus {

/// The curvature field H0, Å^-1. r and R are the radii of atom and probe, d is the distance from the axis of two atoms.
enum class CurvatureField {
    Parallel,      ///< mean curvature of the parallel surface through each point: exact at every distance
    Sharp,         ///< half the discrete Laplacian of s: the steady state is s itself, sharp ridges included
    Paper,         ///< as printed, constant along normals: 1/r, -1/R, and for two atoms (1/d - 1/R)/2
    PaperLiteral,  ///< as Paper, but -1/R for two atoms that do not intersect
};

/// What turns Φ into a signed distance before every step.
enum class Reinitialiser {
    None,
    ClosestPoint,  ///< distance from the zero set of the spline
    Paper,         ///< eq. 3.6 with the sign corrected, until eq. 3.7 holds or for eight iterations
    PaperLiteral,  ///< eq. 3.6 as printed, which picks the downwind side
    Godunov,       ///< first-order upwind differences between neighbouring nodes, eight iterations
};

/// The solver of the linear systems. All solvers stop at the same residual.
enum class Solver {
    Richardson,  ///< corrections by an approximate inverse, which is a stencil itself
    Cg,          ///< conjugate gradients
    Gmres,       ///< generalised minimal residuals, as in the paper
};

/// The factor |∇Φ| in the curvature term.
enum class Slope {
    Unit,      ///< 1
    Computed,  ///< from central differences
};

/// The names of the three predefined flows.
enum class FlowName { Anchored, Parallel, Paper };

/// The parts of a flow.
struct FlowOptions {
    FlowName name = FlowName::Anchored;  ///< the predefined flow that sets the other members, unless they are changed
    CurvatureField curvature = CurvatureField::Parallel;
    double anchor = 16.0;  ///< λ, in units of spacing^-2; 0 for none
    Reinitialiser reinitialiser = Reinitialiser::None;
    Solver solver = Solver::Richardson;
    Slope slope = Slope::Unit;
    /// τ, in units of spacing². Infinity, allowed with an anchor only, gives the steady state in one solve.
    double time_step = std::numeric_limits<double>::infinity();
    double half_width = 3.0;  ///< k: unknowns are the nodes with |Φ| (anchored: |s|) below k spacings
    int max_steps = 30;       ///< at least 1
    /// The flow stops, with an anchor, when the mean |ΔΦ|/(τλ), an estimate of the distance left to go, falls below
    /// this (spacings); without an anchor, when the mean speed |ΔΦ|/τ falls below this (Å^-1, eq. 3.5).
    double tolerance = 1e-4;

    bool operator==(const FlowOptions&) const = default;
};

/// The three predefined flows. The radius ρ of a sphere around an atom of radius r changes by ρ' = λ(r - ρ) with the
/// anchored flow, ρ' = 0 with the parallel one, and ρ' = 2(1/r - 1/ρ) with that of the paper.
inline constexpr FlowOptions kAnchoredFlow{};
inline constexpr FlowOptions kParallelFlow{.name = FlowName::Parallel,
                                           .anchor = 0.0,
                                           .reinitialiser = Reinitialiser::ClosestPoint,
                                           .time_step = 1.0,
                                           .max_steps = 100,
                                           .tolerance = 1e-2};
inline constexpr FlowOptions kPaperFlow{.name = FlowName::Paper,
                                        .curvature = CurvatureField::Paper,
                                        .anchor = 0.0,
                                        .reinitialiser = Reinitialiser::Paper,
                                        .solver = Solver::Gmres,
                                        .slope = Slope::Computed,
                                        .time_step = 1.0,
                                        .half_width = 4.0,
                                        .max_steps = 100,
                                        .tolerance = 1e-2};

/// The predefined flow of a name.
constexpr const FlowOptions& flow_of(FlowName name) {
    return name == FlowName::Paper ? kPaperFlow : name == FlowName::Parallel ? kParallelFlow : kAnchoredFlow;
}

/// Why a flow ended.
enum class FlowEnd {
    Converged,    ///< FlowOptions::tolerance was reached
    StepsUsedUp,  ///< FlowOptions::max_steps were made
    Stalled,      ///< with an anchor: the residual did not halve within three steps
    Vanished,     ///< nothing is left of the surface
    LeftBand,     ///< without an anchor: the surface moved beyond the band around the SES and the start
};

/// The surface after a step of a flow; the start is step 0.
struct FlowStep {
    int step = 0;
    double time = 0.0;           ///< Å²: the flow's speed is a curvature
    double area = 0.0;           ///< Å², over flat triangles
    double volume = 0.0;         ///< Å³
    double mean_distance = 0.0;  ///< mean distance of the vertices from the exact SES, Å
    double max_distance = 0.0;   ///< largest such distance, Å
    double residual = 0.0;       ///< mean |ΔΦ|/τ where |Φ| < spacing, Å^-1 (eq. 3.5)
    int solver_iterations = 0;
    std::size_t components = 0;  ///< number of connected pieces
    std::int64_t genus = 0;      ///< number of handles of all pieces together
};

/// Called after every step with the mesh of the zero set, on the thread that called compute_surface().
using FlowObserver = std::function<void(const FlowStep&, const Mesh&)>;

/// How a flow went.
struct FlowSummary {
    int steps = 0;
    double time = 0.0;  ///< Å²
    bool converged = false;
    FlowEnd end = FlowEnd::Converged;
    double residual = 0.0;       ///< mean |ΔΦ|/τ where |Φ| < spacing at the last step, Å^-1
    double mean_distance = 0.0;  ///< mean distance of the final mesh's vertices from the exact SES, Å
    double max_distance = 0.0;   ///< largest such distance, Å
    int solver_iterations = 0;   ///< over all steps
    double initial_area = 0.0;   ///< of the zero set of the Gaussian map, Å²; 0 unless SurfaceOptions::initial_area
    int reinitialisations = 0;
    int kept_step = 0;          ///< the step that gave the result: the last; without an anchor, the nearest to the SES
    std::string explanation{};  ///< why the flow did not converge and, without an anchor, how near it came; else empty
};

}  // namespace meniscus
