// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/evolution.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "flow/spline_system.h"
#include "grid/stencil.h"

namespace meniscus {
namespace {

constexpr std::size_t kNodesPerChunk = std::size_t{32} * kBlockNodes;
constexpr double kSolverAccuracy = 1e-5;  // root mean square error of Φ per solve, in spacings
constexpr int kPatience = 3;              // steps in which the residual must halve

// ±margin, by the sign that prevails in each block: what its missing neighbours would hold.
BlockFill fill_by_sign(const BlockGrid& grid, std::span<const float> field, double margin) {
    BlockFill fill(grid.block_count());
    parallel_for(grid.block_count(), 64, [&](std::size_t b) {
        const auto block = field.subspan(b * kBlockNodes, kBlockNodes);
        double sum = 0.0;
        for (const float v : block) sum += v;
        fill[b] = static_cast<float>(sum < 0.0 ? -margin : margin);
    });
    return fill;
}

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
};

// Mean |after - before| over the nodes with |after| < near.
double mean_change(std::span<const float> before, std::span<const float> after, float near) {
    const auto total = parallel_sum<MeanChange>(after.size(), kNodesPerChunk, [&](std::size_t begin, std::size_t end) {
        MeanChange part;
        for (std::size_t n = begin; n < end; ++n)
            if (std::abs(after[n]) < near) part += {std::abs(double{after[n]} - before[n]), 1};
        return part;
    });
    return total.count > 0 ? total.sum / static_cast<double>(total.count) : 0.0;
}

// One anchored evolution in progress.
class AnchoredFlow {
public:
    AnchoredFlow(const BlockGrid& grid, const DistanceBand& band, std::span<const float> start,
                 const EvolutionOptions& options)
        : grid_(grid),
          band_(band),
          tau_(options.time_step * grid.spacing() * grid.spacing()),
          lambda_(options.anchor / (grid.spacing() * grid.spacing())),
          near_(static_cast<float>(options.half_width * grid.spacing())),
          system_(grid),
          fill_(fill_by_sign(grid, band.distance, band.margin)),
          mask_(grid.node_count()),
          outside_(grid.node_count()),
          rhs_(grid.node_count()) {
        result_.values.assign(start.begin(), start.end());
        apply_everywhere(grid_, spline_quasi_interpolant(), band_.distance, fill_, outside_);
        result_.coefficients = outside_;
    }

    // Advances by τ; returns the mean speed |ΔΦ|/τ near the surface.
    double step() {
        find_unknowns();
        const Stencil matrix = (1.0 + tau_ * lambda_) * spline_value() - tau_ * spline_laplacian(grid_.spacing());
        const double accuracy = kSolverAccuracy * grid_.spacing() * (1.0 + tau_ * lambda_);
        result_.solver_iterations +=
            system_.solve(matrix, mask_, fill_, rhs_, result_.coefficients, {.tolerance = accuracy}).iterations;
        apply_everywhere(grid_, spline_value(), result_.coefficients, fill_, rhs_);  // rhs_ becomes the new Φ
        for_each_node(mask_.size(), [&](std::size_t n) {
            if (mask_[n] == 0) rhs_[n] = band_.distance[n];
        });
        const double speed = mean_change(result_.values, rhs_, static_cast<float>(grid_.spacing())) / tau_;
        std::swap(result_.values, rhs_);
        ++result_.steps;
        result_.time += tau_;
        result_.residual = speed;
        return speed;
    }

    double left_to_go(double speed) const { return speed / lambda_ / grid_.spacing(); }
    void set_converged() { result_.converged = true; }
    EvolutionResult take() { return std::move(result_); }

private:
    // Unknowns are the nodes near either surface; all others hold s, clamped, and its coefficients. After a step Φ is
    // near s: then the nodes near s alone make the steady state the same from every start.
    void find_unknowns() {
        const auto tau = static_cast<float>(tau_);
        const auto lambda = static_cast<float>(lambda_);
        const bool at_start = result_.steps == 0;
        for_each_node(mask_.size(), [&](std::size_t n) {
            const float s = band_.distance[n];
            const bool unknown = std::abs(s) < near_ || (at_start && std::abs(result_.values[n]) < near_);
            mask_[n] = unknown ? 1 : 0;
            if (!unknown) result_.coefficients[n] = outside_[n];
            rhs_[n] = result_.values[n] + tau * (lambda * s - 2.0F * band_.curvature[n]);
        });
    }

    const BlockGrid& grid_;
    const DistanceBand& band_;
    double tau_;
    double lambda_;
    float near_;
    SplineSystem system_;
    BlockFill fill_;
    NodeMask mask_;
    std::vector<float> outside_;  // coefficients of s
    std::vector<float> rhs_;
    EvolutionResult result_;
};

}  // namespace

EvolutionResult evolve_anchored(const BlockGrid& grid, const DistanceBand& band, std::span<const float> start,
                                const EvolutionOptions& options, const std::function<void(double)>& step) {
    AnchoredFlow flow(grid, band, start, options);
    std::vector<double> left;  // after each step, in spacings
    while (static_cast<int>(left.size()) < options.max_steps) {
        left.push_back(flow.left_to_go(flow.step()));
        if (left.back() <= options.tolerance) {
            flow.set_converged();
            break;
        }
        const std::size_t n = left.size();
        if (n > kPatience && !(left[n - 1] < 0.5 * left[n - 1 - kPatience])) break;
        if (step) step(std::min(0.9, std::log(left[0] / left.back()) / std::log(left[0] / options.tolerance)));
    }
    return flow.take();
}

std::vector<float> interpolating_coefficients(const BlockGrid& grid, std::span<const float> values, double half_width) {
    const double near = half_width * grid.spacing();
    const BlockFill fill = fill_by_sign(grid, values, near);
    NodeMask mask(grid.node_count());
    for_each_node(mask.size(), [&](std::size_t n) { mask[n] = std::abs(values[n]) < near ? 1 : 0; });
    std::vector<float> coefficients(grid.node_count());
    apply_everywhere(grid, spline_quasi_interpolant(), values, fill, coefficients);
    SplineSystem system(grid);
    system.solve(spline_value(), mask, fill, values, coefficients, {.tolerance = kSolverAccuracy * grid.spacing()});
    return coefficients;
}

}  // namespace meniscus
