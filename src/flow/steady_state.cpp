// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/steady_state.h"

#include <algorithm>
#include <cmath>

#include "core/fresh_memory.h"
#include "core/parallel.h"
#include "flow/spline_system.h"
#include "grid/block_kernels.h"
#include "grid/stencil.h"

namespace meniscus {
namespace {

constexpr std::size_t kNodesPerChunk = std::size_t{32} * kBlockNodes;

// curvature becomes λ s - 2 H0.
void make_right_side(std::span<const float> distance, float lambda, std::span<float> curvature) {
    parallel_chunks(distance.size(), kNodesPerChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) curvature[n] = lambda * distance[n] - 2.0F * curvature[n];
    });
}

bool has_surface(const Unknowns& unknowns, std::span<const float> values, float spacing) {
    return std::any_of(unknowns.blocks.begin(), unknowns.blocks.end(), [&](BlockId block) {
        const auto nodes = values.subspan(std::size_t{block} * kBlockNodes, kBlockNodes);
        return std::any_of(nodes.begin(), nodes.end(), [&](float v) { return std::abs(v) < spacing; });
    });
}

}  // namespace

bool is_one_solve(const FlowOptions& options) {
    return std::isinf(options.time_step) && options.slope == Slope::Unit &&
           options.reinitialiser == Reinitialiser::None;
}

EvolutionResult solve_steady_state(const BlockGrid& grid, DistanceBand band, const FlowOptions& options) {
    const double h = grid.spacing();
    const double lambda = options.anchor / (h * h);
    const Unknowns unknowns = nodes_near(grid, band.distance, static_cast<float>(options.half_width * h));
    const BlockFill fill = fill_by_sign(grid, band.distance, band.margin);
    EvolutionResult result;
    NodeField& coefficients = result.state.coefficients;
    resize_touched(coefficients, grid.node_count());
    apply_everywhere(grid, spline_quasi_interpolant(), band.distance, fill, coefficients);
    make_right_side(band.distance, static_cast<float>(lambda), band.curvature);
    const double tolerance = kSolverAccuracy * h * lambda;
    const SolveResult solved =
        SplineSystem(grid).solve(lambda * spline_value() - spline_laplacian(h), unknowns, fill, band.curvature,
                                 coefficients, {.solver = options.solver, .tolerance = tolerance});
    apply_within(grid, spline_value(), coefficients, fill, unknowns, band.distance);
    result.state.values = std::move(band.distance);
    result.steps = 1;
    result.time = options.time_step;
    result.solver_iterations = solved.iterations;
    if (!has_surface(unknowns, result.state.values, static_cast<float>(h)))
        result.end = FlowEnd::Vanished;
    else
        result.end = solved.residual <= tolerance ? FlowEnd::Converged : FlowEnd::StepsUsedUp;
    return result;
}

}  // namespace meniscus
