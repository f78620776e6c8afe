// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The evolutions that carry the Gaussian start to the solvent-excluded surface, in pieces that combine.
//
// All solve Φ_t = ΔΦ - 2 H0 |∇Φ| + λ(s - Φ) by semi-implicit Euler steps on a tri-cubic B-spline (Pan & Tai 2009,
// eqs. 2.4 and 3.3); s is the exact signed distance. What is known of each: docs/design/flow.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <string>

#include "meniscus/mesh.h"

namespace meniscus {

/// The curvature field H0.
enum class CurvatureField {
    Parallel,      ///< of the parallel surface through the point: exact at every distance from the SES
    Sharp,         ///< half the discrete Laplacian of s: makes s itself the fixed point, ridges and all
    Paper,         ///< as printed, constant along normals: 1/r, -1/R, and for two atoms (1/d - 1/R)/2
    PaperLiteral,  ///< the same, with -1/R for two atoms that do not intersect
};

/// What turns Φ into a signed distance before every step.
enum class Reinitialiser {
    None,
    ClosestPoint,  ///< distance from the zero set of the spline
    Paper,         ///< eq. 3.6 with its sign repaired, until eq. 3.7 or eight iterations
    PaperLiteral,  ///< eq. 3.6 as printed, which picks the downwind side
    Godunov,       ///< first-order upwind differences between neighbouring nodes, eight iterations
};

/// The linear solver. All stop at the same residual.
enum class Solver {
    Richardson,  ///< corrections by an approximate inverse, which is a stencil itself
    Cg,
    Gmres,
};

/// The factor |∇Φ| of H0.
enum class Slope {
    Unit,      ///< 1
    Computed,  ///< from central differences
};

/// The three evolutions by name.
enum class FlowName { Anchored, Parallel, Paper };

struct FlowOptions {
    FlowName name =
        FlowName::Anchored;  ///< the evolution whose pieces those below are, or from which they were changed
    CurvatureField curvature = CurvatureField::Parallel;
    double anchor = 16.0;  ///< λ, in units of spacing^-2; 0 for none
    Reinitialiser reinitialiser = Reinitialiser::None;
    Solver solver = Solver::Richardson;
    Slope slope = Slope::Unit;
    /// τ, in units of spacing². Infinity, with an anchor only: the steady state in one solve, whatever the start.
    double time_step = std::numeric_limits<double>::infinity();
    double half_width = 3.0;  ///< k: unknowns are the nodes with |Φ| (anchored: |s|) below k spacings
    int max_steps = 30;
    /// Anchored: stop when mean |ΔΦ|/(τλ), an estimate of what is left, falls below so many spacings. Without an
    /// anchor: when the mean speed |ΔΦ|/τ falls below so many Å^-1 (eq. 3.5).
    double tolerance = 1e-4;

    bool operator==(const FlowOptions&) const = default;
};

/// The three evolutions by name. A sphere's radius ρ, SES radius r: paper ρ' = 2(1/r - 1/ρ), parallel ρ' = 0,
/// anchored ρ' = λ(r - ρ).
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

constexpr const FlowOptions& flow_of(FlowName name) {
    return name == FlowName::Paper ? kPaperFlow : name == FlowName::Parallel ? kParallelFlow : kAnchoredFlow;
}

/// Why an evolution ended.
enum class FlowEnd {
    Converged,
    StepsUsedUp,
    Stalled,   ///< anchored: the residual did not halve within three steps
    Vanished,  ///< nothing is left of the surface
    LeftBand,  ///< without an anchor: the surface went farther from the SES and the start than the band reaches
};

/// The surface after a step; the start is step 0.
struct FlowStep {
    int step = 0;
    double time = 0.0;           ///< Å²: the flow's speed is a curvature
    double area = 0.0;           ///< Å², over flat triangles
    double volume = 0.0;         ///< Å³
    double mean_distance = 0.0;  ///< of the vertices to the exact SES, Å
    double max_distance = 0.0;
    double residual = 0.0;  ///< mean |ΔΦ|/τ over |Φ| < spacing, Å^-1 (eq. 3.5)
    int solver_iterations = 0;
    std::size_t components = 0;
    std::int64_t genus = 0;  ///< handles of all components together
};

/// Sees every step and the mesh of its zero set; called from the thread of compute_surface().
using FlowObserver = std::function<void(const FlowStep&, const Mesh&)>;

/// How the flow went.
struct FlowSummary {
    int steps = 0;
    double time = 0.0;  ///< Å²
    bool converged = false;
    FlowEnd end = FlowEnd::Converged;
    double residual = 0.0;       ///< mean |ΔΦ|/τ over |Φ| < spacing at the last step, Å^-1
    double mean_distance = 0.0;  ///< of the final mesh's vertices to the exact SES, Å
    double max_distance = 0.0;
    int solver_iterations = 0;  ///< over all steps
    double initial_area = 0.0;  ///< Å², of the Gaussian start; if asked for
    int reinitialisations = 0;
    int kept_step = 0;          ///< whose surface is the result: the last one, without an anchor the nearest to the SES
    std::string explanation{};  ///< why it did not converge, or how near it came without an anchor; else empty
};

}  // namespace meniscus
