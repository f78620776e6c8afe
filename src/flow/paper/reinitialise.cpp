// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/paper/reinitialise.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kBlocksPerTask = 16;  // blocks per task
constexpr int kRim = 2;                     // nodes that the differences reach
constexpr int kMask = kBlockEdge - 1;
constexpr int kEdge = kBlockEdge + 2 * kRim;
constexpr std::array<int, 3> kSteps{1, kEdge, kEdge* kEdge};

using WideBlock = std::array<float, static_cast<std::size_t>(kEdge) * kEdge * kEdge>;

std::size_t wide_entry(int x, int y, int z) {
    const int entry = (x + kRim) + kEdge * ((y + kRim) + kEdge * (z + kRim));
    return static_cast<std::size_t>(entry);
}

// A block and two layers of nodes around it; where there is no block, the value of the nearest node of this one.
void gather_wide(const BlockGrid& grid, const NodeField& values, BlockId block, WideBlock& wide) {
    const auto& around = grid.neighbours(block);
    for (int z = -kRim; z < kBlockEdge + kRim; ++z)
        for (int y = -kRim; y < kBlockEdge + kRim; ++y)
            for (int x = -kRim; x < kBlockEdge + kRim; ++x) {
                const BlockId b = around[static_cast<std::size_t>(neighbour_slot(side_of(x), side_of(y), side_of(z)))];
                const auto inside = [](int i) { return std::clamp(i, 0, kMask); };
                const int node = b == kNoBlock ? node_in_block(inside(x), inside(y), inside(z))
                                               : node_in_block(x & kMask, y & kMask, z & kMask);
                wide[wide_entry(x, y, z)] =
                    values[std::size_t{b == kNoBlock ? block : b} * kBlockNodes + static_cast<std::size_t>(node)];
            }
}

// G of eq. 3.6: the upwind slope less one. `phi` points to the node in a wide block.
double slope_less_one(const float* phi, double spacing, const UpwindScheme& scheme) {
    const double side = *phi < 0.0F ? -1.0 : 1.0;
    double sum = 0.0;
    for (const int step : kSteps) {
        const int reach = scheme.stride * step;
        const double scale = side / (scheme.stride * spacing);
        const double backward = scale * (double{*phi} - phi[-reach]);
        const double forward = scale * (double{*phi} - phi[reach]);
        const double a = std::max(backward, 0.0);
        const double d = scheme.repaired ? std::max(forward, 0.0) : std::min(forward, 0.0);
        sum += std::max(a * a, d * d);
    }
    return std::sqrt(sum) - 1.0;
}

double smoothed_sign(const float* phi, double spacing) {
    double slope2 = 0.0;
    for (const int step : kSteps) {
        const double difference = (double{phi[step]} - phi[-step]) / (2.0 * spacing);
        slope2 += difference * difference;
    }
    const double length2 = double{*phi} * *phi + slope2 * spacing * spacing;
    return length2 > 0.0 ? *phi / std::sqrt(length2) : 0.0;
}

struct Iteration {
    const BlockGrid& grid;
    const UpwindScheme& scheme;
    float limit;  // of |Φ|, Å
};

// One iteration on one block; returns the sum of |ΔΦ|.
double iterate(const Iteration& iteration, BlockId block, const NodeField& values, NodeField& next) {
    const auto& [grid, scheme, limit] = iteration;
    WideBlock wide;
    gather_wide(grid, values, block, wide);
    double change = 0.0;
    for (int z = 0; z < kBlockEdge; ++z)
        for (int y = 0; y < kBlockEdge; ++y)
            for (int x = 0; x < kBlockEdge; ++x) {
                const float* phi = &wide[wide_entry(x, y, z)];
                const double step = scheme.pseudo_step * grid.spacing() * smoothed_sign(phi, grid.spacing()) *
                                    slope_less_one(phi, grid.spacing(), scheme);
                const float value = std::clamp(static_cast<float>(*phi - step), -limit, limit);
                next[std::size_t{block} * kBlockNodes + static_cast<std::size_t>(node_in_block(x, y, z))] = value;
                change += std::abs(double{value} - *phi);
            }
    return change;
}

}  // namespace

int reinitialise_upwind(const BlockGrid& grid, double width, const UpwindScheme& scheme, NodeField& values) {
    const auto limit = static_cast<float>(width);
    for (float& v : values) v = std::clamp(v, -limit, limit);
    NodeField next(values.size(), 0.0F);
    for (int iteration = 1; iteration <= scheme.most_iterations; ++iteration) {
        const double change =
            parallel_sum<double>(grid.block_count(), kBlocksPerTask, [&](std::size_t begin, std::size_t end) {
                double sum = 0.0;
                for (std::size_t b = begin; b < end; ++b)
                    sum += iterate({grid, scheme, limit}, static_cast<BlockId>(b), values, next);
                return sum;
            });
        std::swap(values, next);
        if (change < scheme.least_change * grid.spacing()) return iteration;
    }
    return scheme.most_iterations;
}

}  // namespace meniscus
