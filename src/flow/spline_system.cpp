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

constexpr BlockValues kZeros{};

// Sum of term(k) over `blocks` blocks, in their order.
template <class T, class Term>
T sum_over(std::size_t blocks, const Term& term) {
    return parallel_sum<T>(blocks, kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        T sum{};
        for (std::size_t k = begin; k < end; ++k) sum += term(k);
        return sum;
    });
}

// Calls body(around) with the nodes of the blocks around `block` in a field of the grid, `fill` where there are none.
template <class Body>
auto with_blocks_around(const BlockGrid& grid, std::span<const float> field, BlockId block, float fill,
                        const Body& body) {
    BlockValues missing;
    missing.fill(fill);
    BlocksAround around;
    for (std::size_t slot = 0; slot < std::size(around); ++slot) {
        const BlockId b = grid.neighbours(block)[slot];
        around[slot] = b == kNoBlock ? missing.data() : field.data() + std::size_t{b} * kBlockNodes;
    }
    return body(around);
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

std::vector<float> scaled(const std::vector<float>& vector, double scale) {
    std::vector<float> result(vector.size());
    const auto factor = static_cast<float>(scale);
    parallel_for(vector.size(), kBlocksPerChunk * kBlockNodes, [&](std::size_t n) { result[n] = factor * vector[n]; });
    return result;
}

NodeBits bits_of(const std::uint8_t* mask) {
    NodeBits bits{};
    for (std::size_t n = 0; n < kBlockNodes; ++n)
        bits.rows[n / kBlockEdge] = static_cast<std::uint8_t>(bits.rows[n / kBlockEdge] | mask[n] << n % kBlockEdge);
    return bits;
}

}  // namespace

void apply_everywhere(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field,
                      const BlockFill& fill, std::span<float> result) {
    const BlockKernels& kernels = block_kernels();
    parallel_for(grid.block_count(), kBlocksPerChunk, [&](std::size_t b) {
        with_blocks_around(grid, field, static_cast<BlockId>(b), fill[b], [&](const BlocksAround& around) {
            kernels.apply(weights_of(stencil), around, result.data() + b * kBlockNodes);
        });
    });
}

SplineSystem::SplineSystem(const BlockGrid& grid) : grid_(&grid) {}

// The vectors may keep old values: begin() writes all of residual and direction, apply() all of image.
void SplineSystem::find_active(const NodeMask& mask) {
    active_.clear();
    sets_.clear();
    unknowns_ = 0;
    place_.assign(grid_->block_count(), kNoBlock);
    for (BlockId block = 0; block < grid_->block_count(); ++block) {
        const std::uint8_t* in = mask.data() + std::size_t{block} * kBlockNodes;
        const auto count = static_cast<std::size_t>(std::count(in, in + kBlockNodes, std::uint8_t{1}));
        if (count == 0) continue;
        place_[block] = static_cast<std::uint32_t>(active_.size());
        active_.push_back(block);
        unknowns_ += count;
        sets_.push_back(bits_of(in));
    }
    residual_.resize(active_.size() * kBlockNodes);
    direction_.resize(residual_.size());
    image_.resize(residual_.size());
}

// residual = direction = b - A x on the unknowns; returns its squared norm.
double SplineSystem::begin(const Stencil& stencil, const BlockFill& fill, std::span<const float> b,
                           std::span<const float> x) {
    const BlockKernels& kernels = block_kernels();
    return sum_over<double>(active_.size(), [&](std::size_t k) {
        const BlockId block = active_[k];
        return with_blocks_around(*grid_, x, block, fill[block], [&](const BlocksAround& around) {
            return kernels.begin(weights_of(stencil), around, sets_[k], b.data() + std::size_t{block} * kBlockNodes,
                                 residual_.data() + k * kBlockNodes, direction_.data() + k * kBlockNodes);
        });
    });
}

// image = A direction on the unknowns.
ImageProducts SplineSystem::apply(const Stencil& stencil) {
    const BlockKernels& kernels = block_kernels();
    return sum_over<ImageProducts>(active_.size(), [&](std::size_t k) {
        BlocksAround around;
        for (std::size_t slot = 0; slot < std::size(around); ++slot) {
            const BlockId b = grid_->neighbours(active_[k])[slot];
            const std::uint32_t at = b == kNoBlock ? kNoBlock : place_[b];
            around[slot] = at == kNoBlock ? kZeros.data() : direction_.data() + std::size_t{at} * kBlockNodes;
        }
        return kernels.apply_to_set(weights_of(stencil), around, sets_[k], image_.data() + k * kBlockNodes);
    });
}

double SplineSystem::advance(const CgFactors& factors, std::span<float> x) {
    const BlockKernels& kernels = block_kernels();
    return sum_over<double>(active_.size(), [&](std::size_t k) {
        const std::size_t at = k * kBlockNodes;
        return kernels.advance(factors, image_.data() + at, x.data() + std::size_t{active_[k]} * kBlockNodes,
                               residual_.data() + at, direction_.data() + at);
    });
}

SolveResult SplineSystem::solve(const Stencil& stencil, const NodeMask& mask, const BlockFill& fill,
                                std::span<const float> b, std::span<float> x, const SolveOptions& options) {
    find_active(mask);
    return options.solver == Solver::Cg ? solve_cg(stencil, fill, b, x, options)
                                        : solve_gmres(stencil, fill, b, x, options);
}

double SplineSystem::root_mean_square(double squared_norm) const {
    return unknowns_ > 0 ? std::sqrt(squared_norm / static_cast<double>(unknowns_)) : 0.0;
}

// The next residual's norm is known before the step from that of the image, because the residual is orthogonal to the
// image of the direction before: one pass over memory does all of a step. Only beta rests on it; the norm itself is
// summed again, or rounding would add up (Meurant 1987; Chen & Carson 2020).
SolveResult SplineSystem::solve_cg(const Stencil& stencil, const BlockFill& fill, std::span<const float> b,
                                   std::span<float> x, const SolveOptions& options) {
    double squared = begin(stencil, fill, b, x);
    SolveResult result{0, root_mean_square(squared)};
    while (result.residual > options.tolerance && result.iterations < options.max_iterations) {
        const ImageProducts products = apply(stencil);
        const double alpha = squared / products.with_direction;
        const double beta = std::max(0.0, alpha * alpha * products.with_itself / squared - 1.0);
        squared = advance({static_cast<float>(alpha), static_cast<float>(beta)}, x);
        ++result.iterations;
        result.residual = root_mean_square(squared);
    }
    return result;
}

double SplineSystem::dot_image(const Vector& vector) const {
    return sum_over<double>(active_.size(), [&](std::size_t k) {
        double sum = 0.0;
        for (std::size_t n = k * kBlockNodes; n < (k + 1) * kBlockNodes; ++n) sum += double{image_[n]} * vector[n];
        return sum;
    });
}

// image -= scale · vector; returns the image's squared norm.
double SplineSystem::subtract_from_image(const Vector& vector, double scale) {
    const auto factor = static_cast<float>(scale);
    return sum_over<double>(active_.size(), [&](std::size_t k) {
        double sum = 0.0;
        for (std::size_t n = k * kBlockNodes; n < (k + 1) * kBlockNodes; ++n) {
            image_[n] -= factor * vector[n];
            sum += double{image_[n]} * image_[n];
        }
        return sum;
    });
}

// x += scale · vector.
void SplineSystem::add_to(std::span<float> x, const Vector& vector, double scale) const {
    const auto factor = static_cast<float>(scale);
    parallel_for(active_.size(), kBlocksPerChunk, [&](std::size_t k) {
        float* block = x.data() + std::size_t{active_[k]} * kBlockNodes;
        for (std::size_t n = 0; n < kBlockNodes; ++n) block[n] += factor * vector[k * kBlockNodes + n];
    });
}

// Saad & Schultz 1986: Arnoldi by modified Gram-Schmidt, the small least-squares problem by Givens rotations.
SolveResult SplineSystem::solve_gmres(const Stencil& stencil, const BlockFill& fill, std::span<const float> b,
                                      std::span<float> x, const SolveOptions& options) {
    std::vector<std::vector<float>> basis(kRestart + 1);
    SolveResult result;
    for (;;) {
        const double norm = std::sqrt(begin(stencil, fill, b, x));
        result.residual = root_mean_square(norm * norm);
        if (result.residual <= options.tolerance || result.iterations >= options.max_iterations) return result;
        basis[0] = scaled(residual_, 1.0 / norm);
        HessenbergSolver small(norm);
        while (small.size() < kRestart && root_mean_square(small.residual() * small.residual()) > options.tolerance &&
               result.iterations < options.max_iterations) {
            const std::size_t j = small.size();
            direction_ = basis[j];
            apply(stencil);
            std::vector<double> column(j + 2);
            double squared = 0.0;
            for (std::size_t i = 0; i <= j; ++i) {
                column[i] = dot_image(basis[i]);
                squared = subtract_from_image(basis[i], column[i]);
            }
            column[j + 1] = std::sqrt(squared);
            small.add(std::move(column));
            basis[j + 1] = scaled(image_, squared > 0.0 ? 1.0 / std::sqrt(squared) : 0.0);
            ++result.iterations;
        }
        const std::vector<double> weights = small.solution();
        for (std::size_t j = 0; j < weights.size(); ++j) add_to(x, basis[j], weights[j]);
    }
}

}  // namespace meniscus
