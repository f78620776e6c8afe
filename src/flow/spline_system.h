// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Linear systems with a 27-point stencil on part of the band's nodes, solved matrix-free.
#pragma once

#include <cstddef>
#include <cstdint>
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

/// A field of the grid, and what it holds where blocks are missing.
struct FilledField {
    const BlockGrid& grid;
    std::span<const float> values;
    const BlockFill& fill;
};

/// ±margin, by the sign that prevails in each block: what its missing neighbours would hold.
BlockFill fill_by_sign(const BlockGrid& grid, std::span<const float> field, double margin);

/// The nodes that are unknowns, block by block.
struct Unknowns {
    std::vector<BlockId> blocks;  ///< those with unknowns, ascending
    std::vector<NodeBits> nodes;  ///< of each of them
    std::size_t count = 0;
};

/// The nodes of a mask.
Unknowns unknowns_of(const NodeMask& mask);

/// The nodes with |field| < near.
Unknowns nodes_near(const BlockGrid& grid, std::span<const float> field, float near);

/// result = stencil applied to field, on all nodes of all blocks.
void apply_everywhere(const Stencil& stencil, const FilledField& field, std::span<float> result);

/// result = stencil applied to field, on the unknowns; the other nodes keep what they have.
void apply_within(const Unknowns& unknowns, const Stencil& stencil, const FilledField& field, std::span<float> result);

/// What the stencil applied to x is to be on the unknowns.
struct RightSide {
    enum class Blocks { All, WithUnknowns };

    std::span<const float> values;   ///< of all nodes of the blocks, one block after the other
    Blocks of_blocks = Blocks::All;  ///< of the grid's blocks
};

/// The equations (stencil applied to x) = b on the unknowns, x given on all other nodes.
struct SplineSystem {
    const BlockGrid& grid;
    const Unknowns& unknowns;
    Stencil stencil;        ///< positive definite
    const BlockFill& fill;  ///< what x is where blocks are missing
    RightSide b;
};

struct SolveOptions {
    Solver solver = Solver::Cg;
    double tolerance = 1e-6;  ///< stop when the root mean square of the residual is below it
    int max_iterations = 200;
};

struct SolveResult {
    int iterations = 0;
    double residual = 0.0;  ///< root mean square over the unknowns
};

/// Solves a system by Richardson's iteration, by conjugate gradients or by GMRES (flow/paper/gmres.h).
///
/// Sums run over blocks in fixed order: the same bits for any number of threads, and for any instructions
/// (block_kernels.h). An iteration of the first is one pass over the blocks with unknowns, of the second two
/// (docs/design/performance.md).
///
/// x   start values on the unknowns, known values elsewhere; overwritten on the unknowns only
SolveResult solve(const SplineSystem& system, std::span<float> x, const SolveOptions& options);

/// Root mean square over the unknowns, of which there may be none.
double root_mean_square(const Unknowns& unknowns, double squared_norm);

/// The vectors of conjugate gradients and of GMRES: nodes of the blocks with unknowns, one block after the other.
class KrylovVectors {
public:
    explicit KrylovVectors(const SplineSystem& system);

    /// residual = direction = b - A x; returns its squared norm.
    double begin(std::span<const float> x);
    /// image = A direction
    ImageProducts apply();
    /// A step of conjugate gradients (BlockKernels::advance); returns the residual's squared norm.
    double advance(const CgFactors& factors, std::span<float> x);

    std::vector<float> residual;
    std::vector<float> direction;
    std::vector<float> image;

private:
    const SplineSystem& system_;
    std::vector<std::uint32_t> places_;  // of each block of the grid in the vectors, else kNoBlock
};

}  // namespace meniscus
