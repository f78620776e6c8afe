// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/spline_system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>

#include "core/bits.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kBlocksPerChunk = 32;
constexpr std::size_t kRestart = 30;  // of GMRES
constexpr int kCycle = 3;             // step lengths of Richardson's iteration
constexpr double kLeastGain = 0.2;    // of a cycle: flows have below 0.005
constexpr double kUsualGain = 0.1;    // of a step: a cycle's last one has 0.006 to 0.07, others more

// The part of the range of a product where errors of distances are, as fractions of it (docs/design/flow.md).
constexpr double kFirstError = 0.28;
constexpr double kLastError = 1.06;

constexpr std::size_t kLeastLayer = 256;  // blocks: work for many threads
constexpr std::size_t kLayersKept = 3;    // of the residual: those that the correction of one needs

using BlockValues = std::array<float, kBlockNodes>;

constexpr BlockValues kZeros{};

// Sum of term(tool, k) over `blocks` blocks, in their order; make_tool() makes one for a few of them.
template <class T, class MakeTool, class Term>
T sum_over(std::size_t blocks, const MakeTool& make_tool, const Term& term) {
    return parallel_sum<T>(blocks, kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        auto tool = make_tool();
        T sum{};
        for (std::size_t k = begin; k < end; ++k) sum += term(tool, k);
        return sum;
    });
}

template <class T, class Term>
T sum_over(std::size_t blocks, const Term& term) {
    struct None {};
    return sum_over<T>(
        blocks, [] { return None{}; }, [&term](None, std::size_t k) { return term(k); });
}

// The nodes of the blocks around one block after the other in a field of the grid, its fill where there are none.
class Surroundings {
public:
    Surroundings(const BlockGrid& grid, std::span<const float> field, const BlockFill& fill)
        : grid_(grid), field_(field), fill_(fill) {}

    const BlocksAround& around(BlockId block) {
        if (missing_[0] != fill_[block]) missing_.fill(fill_[block]);  // mostly it is that of the block before
        find_blocks_around(grid_, field_, block, missing_.data(), around_);
        return around_;
    }

private:
    const BlockGrid& grid_;
    std::span<const float> field_;
    const BlockFill& fill_;
    BlockValues missing_{};
    BlocksAround around_;
};

// Of the blocks around the one that comes next, that which no block before had around it.
BlockId last_neighbour(const BlockGrid& grid, BlockId block) {
    return grid.neighbours(block)[static_cast<std::size_t>(neighbour_slot(1, 1, 1))];
}

// Starts to bring the nodes of a block into the cache. No processor foresees which block comes next.
void fetch(const float* nodes) {
    constexpr std::size_t kLine = 16;  // values
    for (std::size_t n = 0; n < kBlockNodes; n += kLine) __builtin_prefetch(nodes + n);
}
void fetch(std::span<const float> field, BlockId block) {
    if (block != kNoBlock) fetch(field.data() + std::size_t{block} * kBlockNodes);
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
        Rotation(double a, double b) : cosine(a / std::sqrt(a * a + b * b)), sine(b / std::sqrt(a * a + b * b)) {}
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

Unknowns unknowns_of(const NodeMask& mask) {
    Unknowns unknowns;
    for (std::size_t first = 0; first < mask.size(); first += kBlockNodes) {
        const std::uint8_t* in = mask.data() + first;
        const auto count = static_cast<std::size_t>(std::count(in, in + kBlockNodes, std::uint8_t{1}));
        if (count == 0) continue;
        unknowns.blocks.push_back(static_cast<BlockId>(first / kBlockNodes));
        unknowns.nodes.push_back(bits_of(in));
        unknowns.count += count;
    }
    return unknowns;
}

}  // namespace

Unknowns nodes_near(const BlockGrid& grid, std::span<const float> field, float near) {
    Unknowns unknowns;
    std::vector<NodeBits>& sets = unknowns.nodes;
    resize_touched(sets, grid.block_count());
    std::vector<std::uint16_t> counts(grid.block_count());
    parallel_for(grid.block_count(), kBlocksPerChunk, [&](std::size_t b) {
        sets[b] = block_kernels().find_near(near, field.data() + b * kBlockNodes);
        std::array<std::uint64_t, sizeof(NodeBits) / sizeof(std::uint64_t)> words;
        std::memcpy(words.data(), sets[b].rows, sizeof(NodeBits));
        for (const std::uint64_t word : words) counts[b] = static_cast<std::uint16_t>(counts[b] + count_bits(word));
    });
    for (std::size_t b = 0; b < counts.size(); ++b) {
        if (counts[b] == 0) continue;
        sets[unknowns.blocks.size()] = sets[b];
        unknowns.blocks.push_back(static_cast<BlockId>(b));
        unknowns.count += counts[b];
    }
    sets.resize(unknowns.blocks.size());
    return unknowns;
}

BlockFill fill_by_sign(const BlockGrid& grid, std::span<const float> field, double margin) {
    BlockFill fill(grid.block_count());
    parallel_for(grid.block_count(), kBlocksPerChunk, [&](std::size_t b) {
        float sums[kBlockEdge] = {};  // by place in a row: vectors add them
        const float* block = field.data() + b * kBlockNodes;
        for (const float* row = block; row != block + kBlockNodes; row += kBlockEdge)
            for (std::size_t x = 0; x < kBlockEdge; ++x) sums[x] += row[x];
        const float sum = std::accumulate(std::begin(sums), std::end(sums), 0.0F);
        fill[b] = static_cast<float>(sum < 0.0F ? -margin : margin);
    });
    return fill;
}

void apply_everywhere(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field,
                      const BlockFill& fill, std::span<float> result) {
    const BlockKernels& kernels = block_kernels();
    parallel_chunks(grid.block_count(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        Surroundings surroundings(grid, field, fill);
        for (std::size_t b = begin; b < end; ++b)
            kernels.apply(weights_of(stencil), surroundings.around(static_cast<BlockId>(b)),
                          result.data() + b * kBlockNodes);
    });
}

void apply_within(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field, const BlockFill& fill,
                  const Unknowns& unknowns, std::span<float> result) {
    const BlockKernels& kernels = block_kernels();
    parallel_chunks(unknowns.blocks.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        Surroundings surroundings(grid, field, fill);
        for (std::size_t k = begin; k < end; ++k)
            kernels.apply_within(weights_of(stencil), surroundings.around(unknowns.blocks[k]), unknowns.nodes[k],
                                 result.data() + std::size_t{unknowns.blocks[k]} * kBlockNodes);
    });
}

SplineSystem::SplineSystem(const BlockGrid& grid) : grid_(&grid) {}

void SplineSystem::set_unknowns(Unknowns unknowns) {
    unknowns_ = std::move(unknowns);
    place_.assign(grid_->block_count(), kNoBlock);
}

// Blocks of the same z, and of more z where they are few.
void SplineSystem::make_layers() {
    layers_.assign(1, 0);
    const std::vector<BlockId>& blocks = unknowns_.blocks;
    for (std::size_t k = 1; k < blocks.size(); ++k)
        if (k - layers_.back() >= kLeastLayer && grid_->coord(blocks[k]).z != grid_->coord(blocks[k - 1]).z)
            layers_.push_back(k);
    layers_.push_back(blocks.size());
    std::size_t largest = 0;
    for (std::size_t l = 0; l + 1 < layers_.size(); ++l) largest = std::max(largest, layers_[l + 1] - layers_[l]);
    for (std::size_t l = 0; l + 1 < layers_.size(); ++l)
        for (std::size_t k = layers_[l]; k < layers_[l + 1]; ++k)
            place_[blocks[k]] = static_cast<std::uint32_t>(l % kLayersKept * largest + (k - layers_[l]));
    resize_touched(residual_, std::min(kLayersKept, layers_.size() - 1) * largest * kBlockNodes);
}

void SplineSystem::make_krylov_vectors() {
    for (std::size_t k = 0; k < unknowns_.blocks.size(); ++k)
        place_[unknowns_.blocks[k]] = static_cast<std::uint32_t>(k);
    // They may keep old values: all are overwritten.
    resize_all_touched(unknowns_.blocks.size() * kBlockNodes, residual_, direction_, image_);
}

// Where the k-th block with unknowns has its part of b.
const float* SplineSystem::right_side(const RightSide& b, std::size_t k) const {
    const std::size_t place = b.of_blocks == RightSide::Blocks::All ? unknowns_.blocks[k] : k;
    return b.values.data() + place * kBlockNodes;
}

// The blocks around one, in a vector on the unknowns; zeros where there are none.
void SplineSystem::find_around(BlockId block, const Vector& vector, BlocksAround& around) const {
    const auto& neighbours = grid_->neighbours(block);
    for (std::size_t slot = 0; slot < std::size(around); ++slot) {
        const std::uint32_t at = neighbours[slot] == kNoBlock ? kNoBlock : place_[neighbours[slot]];
        around[slot] = at == kNoBlock ? kZeros.data() : vector.data() + std::size_t{at} * kBlockNodes;
    }
}

// residual = direction = b - A x on the unknowns; returns its squared norm.
double SplineSystem::begin(const Stencil& stencil, const BlockFill& fill, const RightSide& b,
                           std::span<const float> x) {
    const BlockKernels& kernels = block_kernels();
    const auto surroundings = [&] { return Surroundings(*grid_, x, fill); };
    return sum_over<double>(unknowns_.blocks.size(), surroundings, [&](Surroundings& of_x, std::size_t k) {
        const BlockId block = unknowns_.blocks[k];
        return kernels.begin(weights_of(stencil), of_x.around(block), unknowns_.nodes[k], right_side(b, k),
                             residual_.data() + k * kBlockNodes, direction_.data() + k * kBlockNodes);
    });
}

// image = A direction on the unknowns.
ImageProducts SplineSystem::apply(const Stencil& stencil) {
    const BlockKernels& kernels = block_kernels();
    return sum_over<ImageProducts>(unknowns_.blocks.size(), [&](std::size_t k) {
        BlocksAround around;
        find_around(unknowns_.blocks[k], direction_, around);
        return kernels.apply_to_set(weights_of(stencil), around, unknowns_.nodes[k], image_.data() + k * kBlockNodes);
    });
}

double SplineSystem::advance(const CgFactors& factors, std::span<float> x) {
    const BlockKernels& kernels = block_kernels();
    return sum_over<double>(unknowns_.blocks.size(), [&](std::size_t k) {
        const std::size_t at = k * kBlockNodes;
        return kernels.advance(factors, image_.data() + at, x.data() + std::size_t{unknowns_.blocks[k]} * kBlockNodes,
                               residual_.data() + at, direction_.data() + at);
    });
}

SolveResult SplineSystem::solve(const Stencil& stencil, const NodeMask& mask, const BlockFill& fill,
                                std::span<const float> b, std::span<float> x, const SolveOptions& options) {
    return solve(stencil, unknowns_of(mask), fill, {.values = b}, x, options);
}

SolveResult SplineSystem::solve(const Stencil& stencil, Unknowns unknowns, const BlockFill& fill, const RightSide& b,
                                std::span<float> x, const SolveOptions& options) {
    set_unknowns(std::move(unknowns));
    switch (options.solver) {
        case Solver::Richardson:
            return solve_richardson(stencil, fill, b, x, options);
        case Solver::Cg:
            return solve_cg(stencil, fill, b, x, options);
        case Solver::Gmres:
            return solve_gmres(stencil, fill, b, x, options);
    }
    return {};
}

double SplineSystem::root_mean_square(double squared_norm) const {
    return unknowns_.count > 0 ? std::sqrt(squared_norm / static_cast<double>(unknowns_.count)) : 0.0;
}

// residual = b - A x on the unknowns of a layer; returns its squared norm.
double SplineSystem::find_residual(const Stencil& stencil, const BlockFill& fill, const RightSide& b,
                                   std::span<const float> x, std::size_t layer) {
    const BlockKernels& kernels = block_kernels();
    const std::size_t first = layers_[layer];
    const std::size_t end = layers_[layer + 1];
    const std::vector<BlockId>& blocks = unknowns_.blocks;
    const auto surroundings = [&] { return Surroundings(*grid_, x, fill); };
    return sum_over<double>(end - first, surroundings, [&](Surroundings& of_x, std::size_t i) {
        const std::size_t k = first + i;
        if (k + 1 < end) {
            fetch(right_side(b, k + 1));
            fetch(x, last_neighbour(*grid_, blocks[k + 1]));
        }
        return kernels.find_residual(weights_of(stencil), of_x.around(blocks[k]), unknowns_.nodes[k], right_side(b, k),
                                     residual_.data() + std::size_t{place_[blocks[k]]} * kBlockNodes);
    });
}

// x += inverse applied to residual, on the unknowns of a layer.
void SplineSystem::correct(const Stencil& inverse, std::span<float> x, std::size_t layer) const {
    const BlockKernels& kernels = block_kernels();
    const std::span blocks = blocks_of(layer);
    const NodeBits* nodes = unknowns_.nodes.data() + layers_[layer];
    parallel_for(blocks.size(), kBlocksPerChunk, [&](std::size_t k) {
        if (k + 1 < blocks.size()) fetch(x, blocks[k + 1]);
        BlocksAround around;
        find_around(blocks[k], residual_, around);
        kernels.correct(weights_of(inverse), around, nodes[k], x.data() + std::size_t{blocks[k]} * kBlockNodes);
    });
}

// Returns the squared norm of b - A x and, if there is an inverse, adds it, applied to b - A x, to x. One pass over
// memory: a layer is corrected when the residuals beside it are known, and nobody needs its old values any more.
double SplineSystem::sweep(const Stencil& stencil, const std::optional<Stencil>& inverse, const BlockFill& fill,
                           const RightSide& b, std::span<float> x) {
    const std::size_t layers = layers_.size() - 1;
    double squares = 0.0;
    for (std::size_t l = 0; l < layers; ++l) {
        squares += find_residual(stencil, fill, b, x, l);
        if (inverse && l > 0) correct(*inverse, x, l - 1);
    }
    if (inverse) correct(*inverse, x, layers - 1);
    return squares;
}

// Richardson 1910, with an approximate inverse of the stencil (27 coefficients, too) before the residual. Both are
// multiples of the identity on waves, so the range of the product is known, and with it the step lengths of Chebyshev's
// roots for cycles of kCycle steps (Young 1953). Works in place: a few layers of a residual are all its memory. On sets
// of nodes where both stencils miss most of their neighbours the range is another; conjugate gradients end what a cycle
// does not bring nearer.
SolveResult SplineSystem::solve_richardson(const Stencil& stencil, const BlockFill& fill, const RightSide& b,
                                           std::span<float> x, const SolveOptions& options) {
    make_layers();
    const Stencil inverse = approximate_inverse(stencil);
    const Range range = range_of_product(stencil, inverse);
    const double middle = range.least + 0.5 * (kFirstError + kLastError) * (range.greatest - range.least);
    const double radius = 0.5 * (kLastError - kFirstError) * (range.greatest - range.least);
    const auto correction_of = [&](int step) {
        return (1.0 / (middle + radius * elementary::cos(std::numbers::pi * (step + 0.5) / kCycle))) * inverse;
    };
    SolveResult result;
    double before = std::numeric_limits<double>::infinity();  // residual at the start of a cycle
    bool stalls = false;
    do {
        const int step = result.iterations % kCycle;
        result.residual = root_mean_square(sweep(stencil, correction_of(step), fill, b, x));
        if (step == 0) stalls = !(result.residual < kLeastGain * std::exchange(before, result.residual));
        ++result.iterations;
        // That was the residual before the step. To look for what is left costs half a step.
        if (result.residual * kUsualGain <= options.tolerance || result.iterations == options.max_iterations)
            result.residual = root_mean_square(sweep(stencil, {}, fill, b, x));
    } while (!stalls && result.residual > options.tolerance && result.iterations < options.max_iterations);
    if (result.residual <= options.tolerance || result.iterations >= options.max_iterations) return result;
    const SolveResult rest =
        solve_cg(stencil, fill, b, x,
                 {.tolerance = options.tolerance, .max_iterations = options.max_iterations - result.iterations});
    return {result.iterations + rest.iterations, rest.residual};
}

// The next residual's norm is known before the step from that of the image, because the residual is orthogonal to the
// image of the direction before: one pass over memory does all of a step. Only beta rests on it; the norm itself is
// summed again, or rounding would add up (Meurant 1987; Chen & Carson 2020).
SolveResult SplineSystem::solve_cg(const Stencil& stencil, const BlockFill& fill, const RightSide& b,
                                   std::span<float> x, const SolveOptions& options) {
    make_krylov_vectors();
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
    return sum_over<double>(unknowns_.blocks.size(), [&](std::size_t k) {
        double sum = 0.0;
        for (std::size_t n = k * kBlockNodes; n < (k + 1) * kBlockNodes; ++n) sum += double{image_[n]} * vector[n];
        return sum;
    });
}

// image -= scale · vector; returns the image's squared norm.
double SplineSystem::subtract_from_image(const Vector& vector, double scale) {
    const auto factor = static_cast<float>(scale);
    return sum_over<double>(unknowns_.blocks.size(), [&](std::size_t k) {
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
    parallel_for(unknowns_.blocks.size(), kBlocksPerChunk, [&](std::size_t k) {
        float* block = x.data() + std::size_t{unknowns_.blocks[k]} * kBlockNodes;
        for (std::size_t n = 0; n < kBlockNodes; ++n) block[n] += factor * vector[k * kBlockNodes + n];
    });
}

// Saad & Schultz 1986: Arnoldi by modified Gram-Schmidt, the small least-squares problem by Givens rotations.
SolveResult SplineSystem::solve_gmres(const Stencil& stencil, const BlockFill& fill, const RightSide& b,
                                      std::span<float> x, const SolveOptions& options) {
    make_krylov_vectors();
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
