// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Linear systems with a 27-point stencil on part of the band's nodes, solved matrix-free.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "grid/block_grid.h"
#include "grid/block_kernels.h"
#include "grid/stencil.h"
#include "meniscus/flow.h"

namespace meniscus {

/// 1 for nodes that are unknowns, else 0; one entry per node.
using NodeMask = std::vector<std::uint8_t>;

/// One value per block for the nodes of its missing neighbours.
using BlockFill = std::vector<float>;

/// result = stencil applied to field, on all nodes of all blocks.
void apply_everywhere(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field,
                      const BlockFill& fill, std::span<float> result);

/// The nodes that are unknowns, block by block.
struct Unknowns {
    std::vector<BlockId> blocks;  ///< those with unknowns, ascending
    std::vector<NodeBits> nodes;  ///< of each of them
    std::size_t count = 0;
};

/// Those with |field| < near.
Unknowns nodes_near(const BlockGrid& grid, std::span<const float> field, float near);

/// ±margin, by the sign that prevails in each block: what its missing neighbours would hold.
BlockFill fill_by_sign(const BlockGrid& grid, std::span<const float> field, double margin);

/// result = stencil applied to field, on the unknowns; the other nodes keep what they have.
void apply_within(const BlockGrid& grid, const Stencil& stencil, std::span<const float> field, const BlockFill& fill,
                  const Unknowns& unknowns, std::span<float> result);

struct SolveOptions {
    Solver solver = Solver::Cg;
    double tolerance = 1e-6;  ///< stop when the root mean square of the residual is below it
    int max_iterations = 200;
};

struct SolveResult {
    int iterations = 0;
    double residual = 0.0;  ///< root mean square over the unknowns
};

/// What the stencil applied to x is to be on the unknowns.
struct RightSide {
    enum class Blocks { All, WithUnknowns };

    std::span<const float> values;   ///< of all nodes of the blocks, one block after the other
    Blocks of_blocks = Blocks::All;  ///< of the grid's blocks
};

/// Solves (stencil applied to x) = b on the nodes of the mask, x given on all others, by Richardson's iteration, by
/// conjugate gradients or by GMRES restarted every 30 iterations, which needs as many vectors.
///
/// The stencil must be positive definite. Sums run over blocks in fixed order: the same bits for any number of threads,
/// and for any instructions (block_kernels.h). An iteration of the first is one pass over the blocks with unknowns,
/// of the second two (docs/design/performance.md). Reuses its memory from solve to solve.
class SplineSystem {
public:
    explicit SplineSystem(const BlockGrid& grid);

    /// x: start values on the mask, known values elsewhere; overwritten on the mask only. b: on all nodes of the grid.
    SolveResult solve(const Stencil& stencil, const NodeMask& mask, const BlockFill& fill, std::span<const float> b,
                      std::span<float> x, const SolveOptions& options);

    /// The same on the unknowns that are listed, with b on those blocks that it says.
    SolveResult solve(const Stencil& stencil, Unknowns unknowns, const BlockFill& fill, const RightSide& b,
                      std::span<float> x, const SolveOptions& options);

private:
    using Vector = std::vector<float>;  // nodes of the active blocks, one block after the other

    SolveResult solve_richardson(const Stencil& stencil, const BlockFill& fill, const RightSide& b, std::span<float> x,
                                 const SolveOptions& options);
    SolveResult solve_cg(const Stencil& stencil, const BlockFill& fill, const RightSide& b, std::span<float> x,
                         const SolveOptions& options);
    SolveResult solve_gmres(const Stencil& stencil, const BlockFill& fill, const RightSide& b, std::span<float> x,
                            const SolveOptions& options);
    void set_unknowns(Unknowns unknowns);
    void make_krylov_vectors();
    void make_layers();
    std::span<const BlockId> blocks_of(std::size_t layer) const {
        return std::span(unknowns_.blocks).subspan(layers_[layer], layers_[layer + 1] - layers_[layer]);
    }
    double sweep(const Stencil& stencil, const std::optional<Stencil>& inverse, const BlockFill& fill,
                 const RightSide& b, std::span<float> x);
    double find_residual(const Stencil& stencil, const BlockFill& fill, const RightSide& b, std::span<const float> x,
                         std::size_t layer);
    void correct(const Stencil& inverse, std::span<float> x, std::size_t layer) const;
    const float* right_side(const RightSide& b, std::size_t k) const;
    void find_around(BlockId block, const Vector& vector, BlocksAround& around) const;
    double begin(const Stencil& stencil, const BlockFill& fill, const RightSide& b, std::span<const float> x);
    ImageProducts apply(const Stencil& stencil);
    double advance(const CgFactors& factors, std::span<float> x);
    double root_mean_square(double squared_norm) const;
    double dot_image(const Vector& vector) const;
    double subtract_from_image(const Vector& vector, double scale);
    void add_to(std::span<float> x, const Vector& vector, double scale) const;

    const BlockGrid* grid_;
    Unknowns unknowns_;
    std::vector<std::uint32_t> place_;  // of each block with unknowns in the vectors, else kNoBlock
    std::vector<std::size_t> layers_;   // of Richardson's iteration: where they begin among the blocks
    Vector residual_;                   // of Richardson's iteration: of the last few layers
    Vector direction_;
    Vector image_;  // stencil applied to direction
};

}  // namespace meniscus
