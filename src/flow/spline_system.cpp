// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/spline_system.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kBlocksPerChunk = 32;

using BlockValues = std::array<float, kBlockNodes>;

void apply_to_block(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field, BlockId block,
                    float fill, std::span<float, kBlockNodes> result) {
    std::array<float, kPaddedNodes> padded;
    gather_padded(grid, field, block, fill, padded);
    apply_stencil(stencil, padded, result);
}

// Calls term(block's first node) for every listed block and adds what it returns, in the list's order.
template <class Term>
double sum_over(std::span<const BlockId> blocks, const Term& term) {
    return parallel_sum<double>(blocks.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t k = begin; k < end; ++k) sum += term(blocks[k]);
        return sum;
    });
}

}  // namespace

void apply_everywhere(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field,
                      const BlockFill& fill, std::span<float> result) {
    parallel_for(grid.block_count(), kBlocksPerChunk, [&](std::size_t b) {
        apply_to_block(grid, stencil, field, static_cast<BlockId>(b), fill[b],
                       std::span<float, kBlockNodes>(result.data() + b * kBlockNodes, kBlockNodes));
    });
}

SplineSystem::SplineSystem(const BlockGrid& grid)
    : grid_(&grid), residual_(grid.node_count()), direction_(grid.node_count()), image_(grid.node_count()) {}

// residual = b - A x on the mask, 0 elsewhere; returns its squared norm.
double SplineSystem::start(const Stencil& stencil, const NodeMask& mask, const BlockFill& fill,
                           std::span<const float> b, std::span<const float> x) {
    active_.clear();
    unknowns_ = 0;
    for (BlockId block = 0; block < grid_->block_count(); ++block) {
        const auto first = mask.begin() + static_cast<std::ptrdiff_t>(std::size_t{block} * kBlockNodes);
        const auto count = static_cast<std::size_t>(std::count(first, first + kBlockNodes, std::uint8_t{1}));
        if (count > 0) active_.push_back(block);
        unknowns_ += count;
    }
    // Inactive neighbours are read by the stencil: they must hold zero, whatever an earlier solve left there.
    std::fill(direction_.begin(), direction_.end(), 0.0F);
    return sum_over(active_, [&](BlockId block) {
        BlockValues image;
        apply_to_block(*grid_, stencil, x, block, fill[block], image);
        const std::size_t first = std::size_t{block} * kBlockNodes;
        double sum = 0.0;
        for (std::size_t n = 0; n < kBlockNodes; ++n) {
            const float r = mask[first + n] != 0 ? b[first + n] - image[n] : 0.0F;
            residual_[first + n] = direction_[first + n] = r;
            sum += double{r} * r;
        }
        return sum;
    });
}

// image = A direction on the mask; returns direction · image.
double SplineSystem::apply(const Stencil& stencil, const NodeMask& mask) {
    return sum_over(active_, [&](BlockId block) {
        BlockValues image;
        apply_to_block(*grid_, stencil, direction_, block, 0.0F, image);
        const std::size_t first = std::size_t{block} * kBlockNodes;
        double sum = 0.0;
        for (std::size_t n = 0; n < kBlockNodes; ++n) {
            const float value = mask[first + n] != 0 ? image[n] : 0.0F;
            image_[first + n] = value;
            sum += double{value} * direction_[first + n];
        }
        return sum;
    });
}

// x += alpha direction, residual -= alpha image; returns the residual's squared norm.
double SplineSystem::advance(double alpha, std::span<float> x) {
    const auto step = static_cast<float>(alpha);
    return sum_over(active_, [&](BlockId block) {
        const std::size_t first = std::size_t{block} * kBlockNodes;
        double sum = 0.0;
        for (std::size_t n = first; n < first + kBlockNodes; ++n) {
            x[n] += step * direction_[n];
            residual_[n] -= step * image_[n];
            sum += double{residual_[n]} * residual_[n];
        }
        return sum;
    });
}

void SplineSystem::turn(double beta) {
    const auto keep = static_cast<float>(beta);
    parallel_for(active_.size(), kBlocksPerChunk, [&](std::size_t k) {
        const std::size_t first = std::size_t{active_[k]} * kBlockNodes;
        for (std::size_t n = first; n < first + kBlockNodes; ++n) direction_[n] = residual_[n] + keep * direction_[n];
    });
}

SolveResult SplineSystem::solve(const Stencil& stencil, const NodeMask& mask, const BlockFill& fill,
                                std::span<const float> b, std::span<float> x, const SolveOptions& options) {
    double squared = start(stencil, mask, fill, b, x);
    const auto rms = [&] { return unknowns_ > 0 ? std::sqrt(squared / static_cast<double>(unknowns_)) : 0.0; };
    SolveResult result{0, rms()};
    while (result.residual > options.tolerance && result.iterations < options.max_iterations) {
        const double alpha = squared / apply(stencil, mask);
        const double next = advance(alpha, x);
        turn(next / squared);
        squared = next;
        ++result.iterations;
        result.residual = rms();
    }
    return result;
}

}  // namespace meniscus
