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
constexpr std::size_t kRestart = 30;  // of GMRES

using BlockValues = std::array<float, kBlockNodes>;

void apply_to_block(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field, BlockId block,
                    float fill, std::span<float, kBlockNodes> result) {
    std::array<float, kPaddedNodes> padded;
    gather_padded<float>(grid, field, block, fill, padded);
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

// Least squares min |e1·norm - H y| for a Hessenberg matrix H that grows by columns.
class HessenbergSolver {
public:
    explicit HessenbergSolver(double norm) : right_{norm} {}

    std::size_t size() const { return columns_.size(); }
    double residual() const { return std::abs(right_.back()); }

    void add(std::vector<double> column) {
        const std::size_t j = size();
        for (std::size_t i = 0; i < j; ++i) rotations_[i].turn(column[i], column[i + 1]);
        rotations_.push_back(Rotation(column[j], column[j + 1]));
        rotations_[j].turn(column[j], column[j + 1]);
        right_.push_back(0.0);
        rotations_[j].turn(right_[j], right_[j + 1]);
        columns_.push_back(std::move(column));
    }

    std::vector<double> solution() const {
        std::vector<double> y(right_.begin(), right_.end() - 1);
        for (std::size_t i = y.size(); i-- > 0;) {
            for (std::size_t j = i + 1; j < y.size(); ++j) y[i] -= columns_[j][i] * y[j];
            y[i] /= columns_[i][i];
        }
        return y;
    }

private:
    struct Rotation {
        double cosine;
        double sine;
        Rotation(double a, double b) : cosine(a / std::hypot(a, b)), sine(b / std::hypot(a, b)) {}
        void turn(double& a, double& b) const {
            const double turned = cosine * a + sine * b;
            b = cosine * b - sine * a;
            a = turned;
        }
    };

    std::vector<std::vector<double>> columns_;
    std::vector<Rotation> rotations_;
    std::vector<double> right_;
};

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
    return options.solver == Solver::Cg ? solve_cg(stencil, mask, fill, b, x, options)
                                        : solve_gmres(stencil, mask, fill, b, x, options);
}

double SplineSystem::root_mean_square(double squared_norm) const {
    return unknowns_ > 0 ? std::sqrt(squared_norm / static_cast<double>(unknowns_)) : 0.0;
}

SolveResult SplineSystem::solve_cg(const Stencil& stencil, const NodeMask& mask, const BlockFill& fill,
                                   std::span<const float> b, std::span<float> x, const SolveOptions& options) {
    double squared = start(stencil, mask, fill, b, x);
    SolveResult result{0, root_mean_square(squared)};
    while (result.residual > options.tolerance && result.iterations < options.max_iterations) {
        const double alpha = squared / apply(stencil, mask);
        const double next = advance(alpha, x);
        turn(next / squared);
        squared = next;
        ++result.iterations;
        result.residual = root_mean_square(squared);
    }
    return result;
}

void SplineSystem::copy_scaled(std::span<const float> field, double scale, std::vector<float>& vector) const {
    const auto factor = static_cast<float>(scale);
    vector.resize(active_.size() * kBlockNodes);
    parallel_for(active_.size(), kBlocksPerChunk, [&](std::size_t k) {
        const std::size_t first = std::size_t{active_[k]} * kBlockNodes;
        for (std::size_t n = 0; n < kBlockNodes; ++n) vector[k * kBlockNodes + n] = factor * field[first + n];
    });
}

void SplineSystem::set_direction(const std::vector<float>& vector) {
    parallel_for(active_.size(), kBlocksPerChunk, [&](std::size_t k) {
        std::copy_n(vector.begin() + static_cast<std::ptrdiff_t>(k * kBlockNodes), kBlockNodes,
                    direction_.begin() + static_cast<std::ptrdiff_t>(std::size_t{active_[k]} * kBlockNodes));
    });
}

double SplineSystem::dot_image(const std::vector<float>& vector) const {
    return parallel_sum<double>(active_.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t first = std::size_t{active_[k]} * kBlockNodes;
            for (std::size_t n = 0; n < kBlockNodes; ++n)
                sum += double{image_[first + n]} * vector[k * kBlockNodes + n];
        }
        return sum;
    });
}

// image -= scale · vector; returns the image's squared norm.
double SplineSystem::subtract_from_image(const std::vector<float>& vector, double scale) {
    const auto factor = static_cast<float>(scale);
    return parallel_sum<double>(active_.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t k = begin; k < end; ++k) {
            const std::size_t first = std::size_t{active_[k]} * kBlockNodes;
            for (std::size_t n = 0; n < kBlockNodes; ++n) {
                image_[first + n] -= factor * vector[k * kBlockNodes + n];
                sum += double{image_[first + n]} * image_[first + n];
            }
        }
        return sum;
    });
}

// Saad & Schultz 1986: Arnoldi by modified Gram-Schmidt, the small least-squares problem by Givens rotations.
SolveResult SplineSystem::solve_gmres(const Stencil& stencil, const NodeMask& mask, const BlockFill& fill,
                                      std::span<const float> b, std::span<float> x, const SolveOptions& options) {
    std::vector<std::vector<float>> basis(kRestart + 1);
    SolveResult result;
    for (;;) {
        const double norm = std::sqrt(start(stencil, mask, fill, b, x));
        result.residual = root_mean_square(norm * norm);
        if (result.residual <= options.tolerance || result.iterations >= options.max_iterations) return result;
        copy_scaled(residual_, 1.0 / norm, basis[0]);
        HessenbergSolver small(norm);
        while (small.size() < kRestart && root_mean_square(small.residual() * small.residual()) > options.tolerance &&
               result.iterations < options.max_iterations) {
            const std::size_t j = small.size();
            set_direction(basis[j]);
            apply(stencil, mask);
            std::vector<double> column(j + 2);
            double squared = 0.0;
            for (std::size_t i = 0; i <= j; ++i) {
                column[i] = dot_image(basis[i]);
                squared = subtract_from_image(basis[i], column[i]);
            }
            column[j + 1] = std::sqrt(squared);
            small.add(std::move(column));
            copy_scaled(image_, squared > 0.0 ? 1.0 / std::sqrt(squared) : 0.0, basis[j + 1]);
            ++result.iterations;
        }
        const std::vector<double> weights = small.solution();
        for (std::size_t j = 0; j < weights.size(); ++j) {
            set_direction(basis[j]);
            advance(weights[j], x);
        }
    }
}

}  // namespace meniscus
