// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Arithmetic on whole blocks, for the linear solver: stencils, and the passes of conjugate gradients.
//
// row_kernels.cpp holds it and is compiled once for every set of instructions. All give the same bits: the same
// operations in the same order, no fused multiply-add, one sum for each place in a row of eight nodes.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "grid/block_grid.h"
#include "grid/stencil.h"

namespace meniscus {

/// A stencil's coefficients as they are applied.
struct StencilWeights {
    float centre;
    float face;
    float edge;
    float corner;
};

constexpr StencilWeights weights_of(const Stencil& s) {
    return {static_cast<float>(s.centre), static_cast<float>(s.face), static_cast<float>(s.edge),
            static_cast<float>(s.corner)};
}

/// The nodes of the 27 blocks around and including one (see neighbour_slot); of a stand-in where there is no block.
using BlocksAround = std::array<const float*, 27>;

/// The blocks around one in a field of the grid, `missing` where there is no block.
BlocksAround blocks_around(const BlockGrid& grid, std::span<const float> field, BlockId block, const float* missing);

/// A set of a block's nodes: node (x, y, z) is bit x of rows[y + 8 z].
struct NodeBits {
    std::uint8_t rows[kBlockNodes / kBlockEdge];
};

struct ImageProducts {
    double with_direction = 0.0;
    double with_itself = 0.0;
    ImageProducts& operator+=(const ImageProducts& other) {
        with_direction += other.with_direction;
        with_itself += other.with_itself;
        return *this;
    }
};

/// Factors of a step of conjugate gradients.
struct CgFactors {
    float alpha;
    float beta;
};

/// A function on a block that is a product of one factor per axis.
struct AxisProduct {
    double x[kBlockEdge];
    double y[kBlockEdge];
    double z[kBlockEdge];
};

/// Arrays hold the nodes of one block, as fields on the grid do, and do not overlap.
struct BlockKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"

    /// image = stencil applied to the block in the middle.
    void (*apply)(const StencilWeights& weights, const BlocksAround& around, float* image);

    /// The same on the nodes of the set; the others keep what they have.
    void (*apply_within)(const StencilWeights& weights, const BlocksAround& around, const NodeBits& set, float* image);

    /// As apply() on the nodes of the set, 0 on the others; returns scalar products of the image.
    ImageProducts (*apply_to_set)(const StencilWeights& weights, const BlocksAround& direction, const NodeBits& set,
                                  float* image);

    /// residual = direction = b - stencil applied to x on the set, 0 on the others; returns the residual's squared
    /// norm.
    double (*begin)(const StencilWeights& weights, const BlocksAround& x, const NodeBits& set, const float* b,
                    float* residual, float* direction);

    /// x += alpha direction, residual -= alpha image, direction = residual + beta direction; returns the residual's
    /// squared norm.
    double (*advance)(const CgFactors& factors, const float* image, float* x, float* residual, float* direction);

    /// The nodes with |field| < near.
    NodeBits (*find_near)(float near, const float* field);

    /// sums += product, but for rows whose factors of y and z give `negligible` at most.
    void (*add_product)(const AxisProduct& product, double negligible, double* sums);

    /// residual as begin() makes it.
    double (*find_residual)(const StencilWeights& weights, const BlocksAround& x, const NodeBits& set, const float* b,
                            float* residual);

    /// x += stencil applied to residual, on the set.
    void (*correct)(const StencilWeights& weights, const BlocksAround& residual, const NodeBits& set, float* x);
};

/// The kernels that this machine can run, the slowest first: the plain ones.
std::vector<BlockKernels> supported_block_kernels();

/// The kernels whose instructions the environment variable MENISCUS_INSTRUCTIONS names, else the fastest ones; the
/// same from the first call to the end of the program.
const BlockKernels& block_kernels();

}  // namespace meniscus
