// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/evolution.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

// Of |after - before| over the nodes with |after| < near.
MeanChange change_near(std::span<const float> before, std::span<const float> after, float near) {
    return parallel_sum<MeanChange>(after.size(), kNodesPerChunk, [&](std::size_t begin, std::size_t end) {
        MeanChange part;
        for (std::size_t n = begin; n < end; ++n)
            if (std::abs(after[n]) < near) part += {std::abs(double{after[n]} - before[n]), 1};
        return part;
    });
}

// |∇Φ| by central differences.
NodeField computed_slope(const BlockGrid& grid, std::span<const float> values, const BlockFill& fill) {
    NodeField slope(values.size(), 0.0F);
    parallel_for(grid.block_count(), 32, [&](std::size_t b) {
        std::array<float, kPaddedNodes> padded;
        gather_padded<float>(grid, values, static_cast<BlockId>(b), fill[b], padded);
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

// One evolution in progress.
class Evolution {
public:
    Evolution(const FlowFields& fields, std::span<const float> start, const FlowOptions& options)
        : fields_(fields),
          grid_(*fields.grid),
          options_(options),
          tau_(options.time_step * grid_.spacing() * grid_.spacing()),
          lambda_(options.anchor / (grid_.spacing() * grid_.spacing())),
          near_(static_cast<float>(options.half_width * grid_.spacing())),
          width_((options.half_width + kBandRim) * grid_.spacing()),
          system_(grid_),
          mask_(grid_.node_count()),
          outside_(grid_.node_count(), 0.0F),
          rhs_(grid_.node_count(), 0.0F) {
        result_.state.values.assign(start.begin(), start.end());
        if (anchored()) hold_outside(fields_.distance, fields_.margin);
        result_.state.coefficients = options_.reinitialiser == Reinitialiser::ClosestPoint
                                         ? interpolating_coefficients(grid_, start, options_.half_width + 1.0)
                                         : outside_;
    }

    // Advances by τ; returns what is left to go, in the units of the tolerance.
    double step() {
        reinitialise();
        if (!anchored()) hold_outside(result_.state.values, width_);
        find_unknowns();
        set_right_side();
        const bool solved = solve();
        apply_everywhere(grid_, spline_value(), result_.state.coefficients, fill_, rhs_);  // rhs_ becomes the new Φ
        const std::span<const float> held =
            anchored() ? fields_.distance : std::span<const float>(result_.state.values);
        for_each_node(mask_.size(), [&](std::size_t n) {
            if (mask_[n] == 0) rhs_[n] = held[n];
        });
        const MeanChange change = change_near(result_.state.values, rhs_, static_cast<float>(grid_.spacing()));
        vanished_ = change.count == 0;
        result_.residual = change.mean() / tau_;
        std::swap(result_.state.values, rhs_);
        ++result_.steps;
        result_.time += tau_;
        if (!solved) return std::numeric_limits<double>::infinity();
        return anchored() ? result_.residual / lambda_ / grid_.spacing() : result_.residual;
    }

    // Whether the zero set is about to run off the nodes that there are.
    bool left_band() const {
        const auto h = static_cast<float>(grid_.spacing());
        for (std::size_t n = 0; n < mask_.size(); ++n)
            if (std::abs(result_.state.values[n]) < h && next_to_missing_block(grid_, n)) return true;
        return false;
    }

    bool vanished() const { return vanished_; }
    bool anchored() const { return options_.anchor > 0.0; }
    void end(FlowEnd why) { result_.end = why; }
    const EvolutionResult& result() const { return result_; }
    EvolutionResult take() { return std::move(result_); }

private:
    // Nodes that are no unknowns keep `field`, and coefficients that take its values.
    void hold_outside(std::span<const float> field, double margin) {
        fill_ = fill_by_sign(grid_, field, margin);
        apply_everywhere(grid_, spline_quasi_interpolant(), field, fill_, outside_);
    }

    void reinitialise() {
        FlowState& state = result_.state;
        switch (options_.reinitialiser) {
            case Reinitialiser::None:
                return;
            case Reinitialiser::ClosestPoint:
                state.values = distance_by_closest_points(grid_, state.values, state.coefficients, width_);
                break;
            case Reinitialiser::Paper:
                reinitialise_upwind(grid_, width_, {}, state.values);
                break;
            case Reinitialiser::PaperLiteral:
                reinitialise_upwind(grid_, width_, {.repaired = false}, state.values);
                break;
            case Reinitialiser::Godunov:
                reinitialise_upwind(grid_, width_, {.stride = 1}, state.values);
                break;
        }
        ++result_.reinitialisations;
    }

    // With an anchor, the nodes near s: then the steady state is the same from every start. Those near the start, too,
    // in the first step, whose Φ is far from s. Without an anchor, the nodes near Φ.
    void find_unknowns() {
        const bool near_values = !anchored() || (result_.steps == 0 && std::isfinite(tau_));
        for_each_node(mask_.size(), [&](std::size_t n) {
            const bool unknown = (anchored() && std::abs(fields_.distance[n]) < near_) ||
                                 (near_values && std::abs(result_.state.values[n]) < near_);
            mask_[n] = unknown ? 1 : 0;
            if (!unknown || !anchored()) result_.state.coefficients[n] = outside_[n];
        });
    }

    // Φ + τ(λ s - 2 H0 |∇Φ|), divided by τ where that is infinite.
    void set_right_side() {
        const auto lambda = static_cast<float>(lambda_);
        const bool steady = std::isinf(tau_);
        const float keep = steady ? 0.0F : 1.0F;
        const float tau = steady ? 1.0F : static_cast<float>(tau_);
        NodeField slope;
        if (options_.slope == Slope::Computed) slope = computed_slope(grid_, result_.state.values, fill_);
        for_each_node(mask_.size(), [&](std::size_t n) {
            const float curving = slope.empty() ? fields_.curvature[n] : fields_.curvature[n] * slope[n];
            rhs_[n] = keep * result_.state.values[n] + tau * (lambda * fields_.distance[n] - 2.0F * curving);
        });
    }

    bool solve() {
        const double scale = std::isinf(tau_) ? lambda_ : 1.0 + tau_ * lambda_;
        const Stencil matrix =
            scale * spline_value() - (std::isinf(tau_) ? 1.0 : tau_) * spline_laplacian(grid_.spacing());
        const double tolerance = kSolverAccuracy * grid_.spacing() * scale;
        const SolveResult solved = system_.solve(matrix, mask_, fill_, rhs_, result_.state.coefficients,
                                                 {.solver = options_.solver, .tolerance = tolerance});
        result_.solver_iterations += solved.iterations;
        return solved.residual <= tolerance;
    }

    const FlowFields& fields_;
    const BlockGrid& grid_;
    const FlowOptions& options_;
    double tau_;
    double lambda_;
    float near_;
    double width_;  // Å: Φ is clamped to it where a reinitialiser runs
    SplineSystem system_;
    BlockFill fill_;
    NodeMask mask_;
    NodeField outside_;  // coefficients of the nodes that are no unknowns
    NodeField rhs_;
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

EvolutionResult evolve(const FlowFields& fields, std::span<const float> start, const FlowOptions& options,
                       const EvolutionObserver& observer) {
    if (is_one_solve(options)) {
        EvolutionResult result = solve_steady_state(*fields.grid,
                                                    {fields.margin,
                                                     {fields.distance.begin(), fields.distance.end()},
                                                     {fields.curvature.begin(), fields.curvature.end()}},
                                                    options);
        if (observer) observer(result, 1.0);
        return result;
    }
    Evolution flow(fields, start, options);
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
    NodeMask mask(grid.node_count());
    for_each_node(mask.size(), [&](std::size_t n) { mask[n] = std::abs(values[n]) < near ? 1 : 0; });
    NodeField coefficients(grid.node_count(), 0.0F);
    apply_everywhere(grid, spline_quasi_interpolant(), values, fill, coefficients);
    SplineSystem system(grid);
    system.solve(spline_value(), mask, fill, values, coefficients, {.tolerance = kSolverAccuracy * grid.spacing()});
    return coefficients;
}

NodeField sharp_curvature(const BlockGrid& grid, const DistanceBand& band, double half_width) {
    const NodeField coefficients = interpolating_coefficients(grid, band.distance, half_width);
    NodeField field(grid.node_count(), 0.0F);
    apply_everywhere(grid, 0.5 * spline_laplacian(grid.spacing()), coefficients,
                     fill_by_sign(grid, band.distance, band.margin), field);
    const auto near = static_cast<float>(half_width * grid.spacing());
    for_each_node(field.size(), [&](std::size_t n) {
        if (!(std::abs(band.distance[n]) < near)) field[n] = band.curvature[n];
    });
    return field;
}

}  // namespace meniscus
