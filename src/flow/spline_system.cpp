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
#include "flow/paper/gmres.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kBlocksPerChunk = 32;
constexpr int kCycle = 3;           // step lengths of Richardson's iteration
constexpr double kLeastGain = 0.2;  // of a cycle: flows have below 0.005
constexpr double kUsualGain = 0.1;  // of a step: a cycle's last one has 0.006 to 0.07, others more

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

// The blocks around one block after the other in a field.
class Surroundings {
public:
    explicit Surroundings(const FilledField& field) : field_(field) {}

    BlocksAround around(BlockId block) {
        const float fill = field_.fill[block];
        if (missing_[0] != fill) missing_.fill(fill);  // mostly it is that of the block before
        return blocks_around(field_.grid, field_.values, block, missing_.data());
    }

private:
    const FilledField& field_;
    BlockValues missing_{};
};

// Vectors on the blocks with unknowns: the blocks around one of them, zeros where there are none.
BlocksAround blocks_around(const std::array<BlockId, 27>& neighbours, std::span<const std::uint32_t> places,
                           std::span<const float> vector) {
    BlocksAround around;
    for (std::size_t slot = 0; slot < around.size(); ++slot) {
        const std::uint32_t at = neighbours[slot] == kNoBlock ? kNoBlock : places[neighbours[slot]];
        around[slot] = at == kNoBlock ? kZeros.data() : vector.data() + std::size_t{at} * kBlockNodes;
    }
    return around;
}

// Where the k-th block with unknowns has its part of b.
const float* right_side(const SplineSystem& system, std::size_t k) {
    const bool all = system.b.of_blocks == RightSide::Blocks::All;
    return system.b.values.data() + (all ? std::size_t{system.unknowns.blocks[k]} : k) * kBlockNodes;
}

NodeBits bits_of(const std::uint8_t* mask) {
    NodeBits bits{};
    for (std::size_t n = 0; n < kBlockNodes; ++n)
        bits.rows[n / kBlockEdge] = static_cast<std::uint8_t>(bits.rows[n / kBlockEdge] | mask[n] << n % kBlockEdge);
    return bits;
}

}  // namespace

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

void apply_everywhere(const Stencil& stencil, const FilledField& field, std::span<float> result) {
    const BlockKernels& kernels = block_kernels();
    parallel_chunks(field.grid.block_count(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        Surroundings surroundings(field);
        for (std::size_t b = begin; b < end; ++b)
            kernels.apply(weights_of(stencil), surroundings.around(static_cast<BlockId>(b)),
                          result.data() + b * kBlockNodes);
    });
}

void apply_within(const Unknowns& unknowns, const Stencil& stencil, const FilledField& field, std::span<float> result) {
    const BlockKernels& kernels = block_kernels();
    parallel_chunks(unknowns.blocks.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        Surroundings surroundings(field);
        for (std::size_t k = begin; k < end; ++k)
            kernels.apply_within(weights_of(stencil), surroundings.around(unknowns.blocks[k]), unknowns.nodes[k],
                                 result.data() + std::size_t{unknowns.blocks[k]} * kBlockNodes);
    });
}

double root_mean_square(const Unknowns& unknowns, double squared_norm) {
    return unknowns.count > 0 ? std::sqrt(squared_norm / static_cast<double>(unknowns.count)) : 0.0;
}

KrylovVectors::KrylovVectors(const SplineSystem& system) : system_(system) {
    const std::vector<BlockId>& blocks = system.unknowns.blocks;
    places_.assign(system.grid.block_count(), kNoBlock);
    for (std::size_t k = 0; k < blocks.size(); ++k) places_[blocks[k]] = static_cast<std::uint32_t>(k);
    resize_all_touched(blocks.size() * kBlockNodes, residual, direction, image);
}

double KrylovVectors::begin(std::span<const float> x) {
    const BlockKernels& kernels = block_kernels();
    const Unknowns& unknowns = system_.unknowns;
    const FilledField field{system_.grid, x, system_.fill};
    const auto surroundings = [&] { return Surroundings(field); };
    return sum_over<double>(unknowns.blocks.size(), surroundings, [&](Surroundings& of_x, std::size_t k) {
        return kernels.begin(weights_of(system_.stencil), of_x.around(unknowns.blocks[k]), unknowns.nodes[k],
                             right_side(system_, k), residual.data() + k * kBlockNodes,
                             direction.data() + k * kBlockNodes);
    });
}

ImageProducts KrylovVectors::apply() {
    const BlockKernels& kernels = block_kernels();
    const Unknowns& unknowns = system_.unknowns;
    return sum_over<ImageProducts>(unknowns.blocks.size(), [&](std::size_t k) {
        const BlocksAround around = blocks_around(system_.grid.neighbours(unknowns.blocks[k]), places_, direction);
        return kernels.apply_to_set(weights_of(system_.stencil), around, unknowns.nodes[k],
                                    image.data() + k * kBlockNodes);
    });
}

double KrylovVectors::advance(const CgFactors& factors, std::span<float> x) {
    const BlockKernels& kernels = block_kernels();
    const std::vector<BlockId>& blocks = system_.unknowns.blocks;
    return sum_over<double>(blocks.size(), [&](std::size_t k) {
        const std::size_t at = k * kBlockNodes;
        return kernels.advance(factors, image.data() + at, x.data() + std::size_t{blocks[k]} * kBlockNodes,
                               residual.data() + at, direction.data() + at);
    });
}

namespace {

// The sweeps of Richardson's iteration, layer after layer: a few layers of a residual are all its memory.
class LayeredSweeps {
public:
    explicit LayeredSweeps(const SplineSystem& system) : system_(system), blocks_(system.unknowns.blocks) {
        for (std::size_t k = 1; k < blocks_.size(); ++k)
            if (k - begins_.back() >= kLeastLayer && z_of(k) != z_of(k - 1)) begins_.push_back(k);
        begins_.push_back(blocks_.size());
        const std::size_t layers = begins_.size() - 1;
        std::size_t largest = 0;
        for (std::size_t l = 0; l < layers; ++l) largest = std::max(largest, begins_[l + 1] - begins_[l]);
        places_.assign(system.grid.block_count(), kNoBlock);
        for (std::size_t l = 0; l < layers; ++l)
            for (std::size_t k = begins_[l]; k < begins_[l + 1]; ++k)
                places_[blocks_[k]] = static_cast<std::uint32_t>(l % kLayersKept * largest + (k - begins_[l]));
        resize_touched(residual_, std::min(kLayersKept, layers) * largest * kBlockNodes);
    }

    // Returns the squared norm of b - A x and, if there is an inverse, adds it, applied to b - A x, to x. One pass over
    // memory: a layer is corrected when the residuals beside it are known, and nobody needs its old values any more.
    double sweep(const std::optional<Stencil>& inverse, std::span<float> x) {
        const std::size_t layers = begins_.size() - 1;
        double squares = 0.0;
        for (std::size_t l = 0; l < layers; ++l) {
            squares += find_residual(x, l);
            if (inverse && l > 0) correct(*inverse, x, l - 1);
        }
        if (inverse) correct(*inverse, x, layers - 1);
        return squares;
    }

private:
    std::int32_t z_of(std::size_t k) const { return system_.grid.coord(blocks_[k]).z; }

    // residual = b - A x on the unknowns of a layer; returns its squared norm.
    double find_residual(std::span<const float> x, std::size_t layer) {
        const BlockKernels& kernels = block_kernels();
        const std::size_t first = begins_[layer];
        const std::size_t end = begins_[layer + 1];
        const FilledField field{system_.grid, x, system_.fill};
        const auto surroundings = [&] { return Surroundings(field); };
        return sum_over<double>(end - first, surroundings, [&](Surroundings& of_x, std::size_t i) {
            const std::size_t k = first + i;
            return kernels.find_residual(weights_of(system_.stencil), of_x.around(blocks_[k]),
                                         system_.unknowns.nodes[k], right_side(system_, k),
                                         residual_.data() + std::size_t{places_[blocks_[k]]} * kBlockNodes);
        });
    }

    // x += inverse applied to residual, on the unknowns of a layer.
    void correct(const Stencil& inverse, std::span<float> x, std::size_t layer) const {
        const BlockKernels& kernels = block_kernels();
        const std::size_t first = begins_[layer];
        const std::size_t end = begins_[layer + 1];
        parallel_for(end - first, kBlocksPerChunk, [&](std::size_t i) {
            const std::size_t k = first + i;
            const BlocksAround around = blocks_around(system_.grid.neighbours(blocks_[k]), places_, residual_);
            kernels.correct(weights_of(inverse), around, system_.unknowns.nodes[k],
                            x.data() + std::size_t{blocks_[k]} * kBlockNodes);
        });
    }

    const SplineSystem& system_;
    const std::vector<BlockId>& blocks_;
    std::vector<std::size_t> begins_{0};  // of layers: blocks of the same z, and of more z where they are few
    std::vector<std::uint32_t> places_;   // of each block of the grid in the residual, else kNoBlock
    std::vector<float> residual_;         // of the last few layers
};

// The next residual's norm is known before the step from that of the image, because the residual is orthogonal to the
// image of the direction before: one pass over memory does all of a step. Only beta rests on it; the norm itself is
// summed again, or rounding would add up (Meurant 1987; Chen & Carson 2020).
SolveResult solve_cg(const SplineSystem& system, std::span<float> x, const SolveOptions& options) {
    KrylovVectors vectors(system);
    double squared = vectors.begin(x);
    SolveResult result{0, root_mean_square(system.unknowns, squared)};
    while (result.residual > options.tolerance && result.iterations < options.max_iterations) {
        const ImageProducts products = vectors.apply();
        const double alpha = squared / products.with_direction;
        const double beta = std::max(0.0, alpha * alpha * products.with_itself / squared - 1.0);
        squared = vectors.advance({static_cast<float>(alpha), static_cast<float>(beta)}, x);
        ++result.iterations;
        result.residual = root_mean_square(system.unknowns, squared);
    }
    return result;
}

// Richardson 1910, with an approximate inverse of the stencil (27 coefficients, too) before the residual. Both are
// multiples of the identity on waves, so the range of the product is known, and with it the step lengths of Chebyshev's
// roots for cycles of kCycle steps (Young 1953). On sets of nodes where both
// stencils miss most of their neighbours the range is another; the caller ends by conjugate gradients what stalls.
SolveResult iterate_richardson(const SplineSystem& system, std::span<float> x, const SolveOptions& options) {
    LayeredSweeps sweeps(system);
    const Stencil inverse = approximate_inverse(system.stencil);
    const Range range = range_of_product(system.stencil, inverse);
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
        result.residual = root_mean_square(system.unknowns, sweeps.sweep(correction_of(step), x));
        if (step == 0) stalls = !(result.residual < kLeastGain * std::exchange(before, result.residual));
        ++result.iterations;
        // This is the residual before the step. To find the one after it costs half a step.
        if (result.residual * kUsualGain <= options.tolerance || result.iterations == options.max_iterations)
            result.residual = root_mean_square(system.unknowns, sweeps.sweep({}, x));
    } while (!stalls && result.residual > options.tolerance && result.iterations < options.max_iterations);
    return result;
}

SolveResult solve_richardson(const SplineSystem& system, std::span<float> x, const SolveOptions& options) {
    const SolveResult result = iterate_richardson(system, x, options);
    if (result.residual <= options.tolerance || result.iterations >= options.max_iterations) return result;
    const int left = options.max_iterations - result.iterations;
    const SolveResult rest = solve_cg(system, x, {.tolerance = options.tolerance, .max_iterations = left});
    return {result.iterations + rest.iterations, rest.residual};
}

}  // namespace

SolveResult solve(const SplineSystem& system, std::span<float> x, const SolveOptions& options) {
    switch (options.solver) {
        case Solver::Richardson:
            return solve_richardson(system, x, options);
        case Solver::Cg:
            return solve_cg(system, x, options);
        case Solver::Gmres:
            return solve_gmres(system, x, options);
    }
    return {};
}

}  // namespace meniscus
