// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/evolution.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "flow/closest_points.h"
#include "flow/paper/reinitialise.h"
#include "flow/spline_system.h"
#include "flow/steady_state.h"
#include "grid/stencil.h"

namespace meniscus {
namespace {

constexpr std::size_t kNodesPerChunk = std::size_t{32} * kBlockNodes;
constexpr int kPatience = 3;    // steps in which the residual of an anchored flow must halve
constexpr int kEdgeOfBand = 2;  // nodes from a missing block where a flow is said to have left the band

void for_each_node(std::size_t nodes, const auto& body) {
    parallel_chunks(nodes, kNodesPerChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t n = begin; n < end; ++n) body(n);
    });
}

struct MeanChange {
    double sum = 0.0;
    std::size_t count = 0;
    MeanChange& operator+=(const MeanChange& other) {
        sum += other.sum;
        count += other.count;
        return *this;
    }
    double mean() const { return count > 0 ? sum / static_cast<double>(count) : 0.0; }
};

// The mean of |after - before| over the nodes with |after| < near.
MeanChange change_near(std::span<const float> before, std::span<const float> after, float near) {
    return parallel_sum<MeanChange>(after.size(), kNodesPerChunk, [&](std::size_t begin, std::size_t end) {
        MeanChange part;
        for (std::size_t n = begin; n < end; ++n)
            if (std::abs(after[n]) < near) part += {std::abs(double{after[n]} - before[n]), 1};
        return part;
    });
}

// |∇Φ| by central differences.
NodeField computed_slope(const FilledField& field) {
    const BlockGrid& grid = field.grid;
    NodeField slope(grid.node_count(), 0.0F);
    parallel_for(grid.block_count(), 32, [&](std::size_t b) {
        const auto padded = gather_padded<float>(grid, field.values, static_cast<BlockId>(b), field.fill[b]);
        const auto scale = static_cast<float>(0.5 / grid.spacing());
        for (int node = 0; node < kBlockNodes; ++node) {
            const int x = node % kBlockEdge;
            const int y = node / kBlockEdge % kBlockEdge;
            const int z = node / (kBlockEdge * kBlockEdge);
            const int entry = x + 1 + kPaddedEdge * (y + 1 + kPaddedEdge * (z + 1));
            const float* at = &padded[static_cast<std::size_t>(entry)];
            float sum = 0.0F;
            for (const int step : {1, kPaddedEdge, kPaddedEdge * kPaddedEdge}) {
                const float d = scale * (at[step] - at[-step]);
                sum += d * d;
            }
            slope[b * kBlockNodes + static_cast<std::size_t>(node)] = std::sqrt(sum);
        }
    });
    return slope;
}

bool next_to_missing_block(const BlockGrid& grid, std::size_t entry) {
    const auto& around = grid.neighbours(static_cast<BlockId>(entry / kBlockNodes));
    const auto node = static_cast<int>(entry % kBlockNodes);
    const int at[3] = {node % kBlockEdge, node / kBlockEdge % kBlockEdge, node / (kBlockEdge * kBlockEdge)};
    for (int axis = 0; axis < 3; ++axis) {
        int side[3] = {0, 0, 0};
        side[axis] = at[axis] < kEdgeOfBand ? -1 : (at[axis] >= kBlockEdge - kEdgeOfBand ? 1 : 0);
        if (around[static_cast<std::size_t>(neighbour_slot(side[0], side[1], side[2]))] == kNoBlock) return true;
    }
    return false;
}

// FlowOptions in Å and on the grid.
struct StepConstants {
    double tau;     // Å²
    double lambda;  // Å^-2
    float near;     // Å: unknowns are nearer
    double width;   // Å: Φ is clamped to it where a reinitialiser runs
};

StepConstants constants_of(const FlowOptions& options, double h) {
    return {.tau = options.time_step * h * h,
            .lambda = options.anchor / (h * h),
            .near = static_cast<float>(options.half_width * h),
            .width = (options.half_width + kBandRim) * h};
}

// What the nodes that are not unknowns hold.
struct HeldField {
    BlockFill fill;
    NodeField coefficients;
};

HeldField held_field(const BlockGrid& grid, std::span<const float> field, double margin) {
    HeldField held{fill_by_sign(grid, field, margin), NodeField(grid.node_count(), 0.0F)};
    apply_everywhere(spline_quasi_interpolant(), {grid, field, held.fill}, held.coefficients);
    return held;
}

void reinitialise(const BlockGrid& grid, Reinitialiser by, double width, FlowState& state) {
    switch (by) {
        case Reinitialiser::None:
            break;
        case Reinitialiser::ClosestPoint:
            state.values = distance_by_closest_points(grid, state.values, state.coefficients, width);
            break;
        case Reinitialiser::Paper:
            reinitialise_upwind(grid, width, {}, state.values);
            break;
        case Reinitialiser::PaperLiteral:
            reinitialise_upwind(grid, width, {.repaired = false}, state.values);
            break;
        case Reinitialiser::Godunov:
            reinitialise_upwind(grid, width, {.stride = 1}, state.values);
            break;
    }
}

// One evolution in progress.
class Evolution {
public:
    Evolution(const BlockGrid& grid, const DistanceBand& band, std::span<const float> start, const FlowOptions& options)
        : band_(band),
          grid_(grid),
          options_(options),
          constants_(constants_of(options, grid_.spacing())),
          next_(grid_.node_count(), 0.0F) {
        FlowState& state = result_.state;
        state.values.assign(start.begin(), start.end());
        if (anchored()) held_ = held_field(grid_, band.distance, band.margin);
        if (options.reinitialiser == Reinitialiser::ClosestPoint)
            state.coefficients = interpolating_coefficients(grid_, start, options.half_width + 1.0);
        else if (anchored())
            state.coefficients = held_.coefficients;
        else
            state.coefficients.assign(grid_.node_count(), 0.0F);
    }

    // Advances by τ; returns what is left to go, in the units of the tolerance.
    double step() {
        FlowState& state = result_.state;
        reinitialise(grid_, options_.reinitialiser, constants_.width, state);
        if (options_.reinitialiser != Reinitialiser::None) ++result_.reinitialisations;
        if (!anchored()) held_ = held_field(grid_, state.values, constants_.width);
        const NodeMask mask = find_unknowns();
        set_right_side();
        const bool solved = solve_step(mask);
        apply_everywhere(spline_value(), {grid_, state.coefficients, held_.fill}, next_);
        const NodeField& held = anchored() ? band_.distance : state.values;
        for_each_node(mask.size(), [&](std::size_t n) {
            if (mask[n] == 0) next_[n] = held[n];
        });
        const MeanChange change = change_near(state.values, next_, static_cast<float>(grid_.spacing()));
        vanished_ = change.count == 0;
        result_.residual = change.mean() / constants_.tau;
        std::swap(state.values, next_);
        ++result_.steps;
        result_.time += constants_.tau;
        if (!solved) return std::numeric_limits<double>::infinity();
        return anchored() ? result_.residual / constants_.lambda / grid_.spacing() : result_.residual;
    }

    // Whether the zero set is about to run off the nodes that there are.
    bool left_band() const {
        const NodeField& values = result_.state.values;
        const auto h = static_cast<float>(grid_.spacing());
        for (std::size_t n = 0; n < values.size(); ++n)
            if (std::abs(values[n]) < h && next_to_missing_block(grid_, n)) return true;
        return false;
    }

    bool vanished() const { return vanished_; }
    bool anchored() const { return options_.anchor > 0.0; }
    void end(FlowEnd why) { result_.end = why; }
    const EvolutionResult& result() const { return result_; }
    EvolutionResult take() { return std::move(result_); }

private:
    // With an anchor, the nodes near s: then the steady state is the same from every start. Those near the start, too,
    // in the first step, whose Φ is far from s. Without an anchor, the nodes near Φ. The others take the coefficients
    // that are held.
    NodeMask find_unknowns() {
        FlowState& state = result_.state;
        NodeMask mask(grid_.node_count());
        const bool near_values = !anchored() || (result_.steps == 0 && std::isfinite(constants_.tau));
        for_each_node(mask.size(), [&](std::size_t n) {
            const bool unknown = (anchored() && std::abs(band_.distance[n]) < constants_.near) ||
                                 (near_values && std::abs(state.values[n]) < constants_.near);
            mask[n] = unknown ? 1 : 0;
            if (!unknown || !anchored()) state.coefficients[n] = held_.coefficients[n];
        });
        return mask;
    }

    // Φ + τ(λ s - 2 H0 |∇Φ|), divided by τ where that is infinite.
    void set_right_side() {
        const NodeField& values = result_.state.values;
        const auto lambda = static_cast<float>(constants_.lambda);
        const bool steady = std::isinf(constants_.tau);
        const float keep = steady ? 0.0F : 1.0F;
        const float tau = steady ? 1.0F : static_cast<float>(constants_.tau);
        NodeField slope;
        if (options_.slope == Slope::Computed) slope = computed_slope({grid_, values, held_.fill});
        for_each_node(next_.size(), [&](std::size_t n) {
            const float curving = slope.empty() ? band_.curvature[n] : band_.curvature[n] * slope[n];
            next_[n] = keep * values[n] + tau * (lambda * band_.distance[n] - 2.0F * curving);
        });
    }

    // Whether the solver reached its accuracy.
    bool solve_step(const NodeMask& mask) {
        const auto& [tau, lambda, near, width] = constants_;
        const double scale = std::isinf(tau) ? lambda : 1.0 + tau * lambda;
        const Unknowns unknowns = unknowns_of(mask);
        const SplineSystem system{
            .grid = grid_,
            .unknowns = unknowns,
            .stencil = scale * spline_value() - (std::isinf(tau) ? 1.0 : tau) * spline_laplacian(grid_.spacing()),
            .fill = held_.fill,
            .b = {next_}};
        const double tolerance = kSolverAccuracy * grid_.spacing() * scale;
        const SolveResult solved =
            solve(system, result_.state.coefficients, {.solver = options_.solver, .tolerance = tolerance});
        result_.solver_iterations += solved.iterations;
        return solved.residual <= tolerance;
    }

    const DistanceBand& band_;
    const BlockGrid& grid_;
    const FlowOptions& options_;
    StepConstants constants_;
    HeldField held_;
    NodeField next_;  // the right side of a step, then the Φ that it leads to
    bool vanished_ = false;
    EvolutionResult result_;
};

// Whether to stop, and why; `left` is what was left to go after each step.
bool ends(Evolution& flow, const std::vector<double>& left, const FlowOptions& options) {
    const std::size_t n = left.size();
    if (flow.vanished())
        flow.end(FlowEnd::Vanished);
    else if (left.back() <= options.tolerance)
        flow.end(FlowEnd::Converged);
    else if (static_cast<int>(n) >= options.max_steps)
        flow.end(FlowEnd::StepsUsedUp);
    else if (flow.anchored() && n > kPatience && !(left[n - 1] < 0.5 * left[n - 1 - kPatience]))
        flow.end(FlowEnd::Stalled);
    else if (!flow.anchored() && flow.left_band())
        flow.end(FlowEnd::LeftBand);
    else
        return false;
    return true;
}

double fraction_done(const std::vector<double>& left, const FlowOptions& options) {
    const double by_steps = static_cast<double>(left.size()) / options.max_steps;
    const double by_residual = elementary::log(left[0] / left.back()) / elementary::log(left[0] / options.tolerance);
    return std::clamp(options.anchor > 0.0 ? by_residual : by_steps, 0.0, 0.9);
}

}  // namespace

EvolutionResult evolve(const BlockGrid& grid, FlowStart from, const FlowOptions& options,
                       const EvolutionObserver& observer) {
    if (is_one_solve(options)) {
        EvolutionResult result = solve_steady_state(grid, std::move(from.band), options);
        if (observer) observer(result, 1.0);
        return result;
    }
    Evolution flow(grid, from.band, from.start.empty() ? from.band.distance : from.start, options);
    std::vector<double> left;
    bool ended = false;
    while (!ended) {
        left.push_back(flow.step());
        ended = ends(flow, left, options);
        if (observer) observer(flow.result(), ended ? 1.0 : fraction_done(left, options));
    }
    return flow.take();
}

NodeField interpolating_coefficients(const BlockGrid& grid, std::span<const float> values, double half_width) {
    const double near = half_width * grid.spacing();
    const BlockFill fill = fill_by_sign(grid, values, near);
    NodeField coefficients(grid.node_count(), 0.0F);
    apply_everywhere(spline_quasi_interpolant(), {grid, values, fill}, coefficients);
    const Unknowns unknowns = nodes_near(grid, values, static_cast<float>(near));
    solve({grid, unknowns, spline_value(), fill, {values}}, coefficients,
          {.tolerance = kSolverAccuracy * grid.spacing()});
    return coefficients;
}

NodeField sharp_curvature(const BlockGrid& grid, const DistanceBand& band, double half_width) {
    const NodeField coefficients = interpolating_coefficients(grid, band.distance, half_width);
    NodeField field(grid.node_count(), 0.0F);
    apply_everywhere(0.5 * spline_laplacian(grid.spacing()),
                     {grid, coefficients, fill_by_sign(grid, band.distance, band.margin)}, field);
    const auto near = static_cast<float>(half_width * grid.spacing());
    for_each_node(field.size(), [&](std::size_t n) {
        if (!(std::abs(band.distance[n]) < near)) field[n] = band.curvature[n];
    });
    return field;
}

}  // namespace meniscus
