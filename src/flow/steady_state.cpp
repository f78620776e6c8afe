// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/steady_state.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "flow/spline_system.h"
#include "grid/block_kernels.h"
#include "grid/stencil.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kUnknownBlocksPerChunk = 32;

// λ s - 2 H0 in the blocks with unknowns.
NodeField right_side(const DistanceBand& band, float lambda, const Unknowns& unknowns) {
    NodeField result;
    resize_touched(result, unknowns.blocks.size() * kBlockNodes);
    parallel_for(unknowns.blocks.size(), kUnknownBlocksPerChunk, [&](std::size_t k) {
        const std::size_t first = std::size_t{unknowns.blocks[k]} * kBlockNodes;
        const float* const distance = band.distance.data() + first;
        const float* const curvature = band.curvature.data() + first;
        float* const out = result.data() + k * kBlockNodes;
        for (std::size_t n = 0; n < kBlockNodes; ++n) out[n] = lambda * distance[n] - 2.0F * curvature[n];
    });
    return result;
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
    const double tolerance = kSolverAccuracy * h * lambda;
    EvolutionResult result;
    NodeField& coefficients = result.state.coefficients;
    const NodeField values = right_side(band, static_cast<float>(lambda), unknowns);
    const SplineSystem system{.grid = grid,
                              .unknowns = unknowns,
                              .stencil = lambda * spline_value() - spline_laplacian(h),
                              .fill = fill,
                              .b = {values, RightSide::Blocks::WithUnknowns}};
    coefficients = std::move(band.curvature);  // which b holds now: its memory is used again
    apply_everywhere(spline_quasi_interpolant(), {grid, band.distance, fill}, coefficients);
    const SolveResult solved = solve(system, coefficients, {.solver = options.solver, .tolerance = tolerance});
    apply_within(unknowns, spline_value(), {grid, coefficients, fill}, band.distance);
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
