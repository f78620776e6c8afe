// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The inner loop of SplineBlock, for several instruction sets. Every set gives the same bits.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "grid/block_grid.h"
#include "meniscus/level_set.h"

namespace meniscus {

/// The coefficients of a block and of what its cells and those next to it need.
struct SplineCoefficients {
    static constexpr int kBefore = 2;                          ///< nodes before the block's first one
    static constexpr int kEdge = kBefore + kBlockEdge + 3;     ///< nodes along an axis
    static constexpr std::size_t kCount = std::size_t{kEdge} * kEdge * kEdge;
    static constexpr std::size_t kRoom = kCount + 4;  ///< whole vectors are read

    Vec3 first;  ///< place of the first node, Å
    double spacing = 0.0;
    std::array<float, kRoom> values;  ///< x fastest; NaN where there is no block
};

/// Where a projection ends, and the spline there.
struct Landing {
    Vec3 point;
    LevelSetSample sample;
};

struct SplineKernels {
    std::string_view instructions;
    /// Projects points onto the zero set by Newton's method. A landing's value is NaN where that fails or leads out of
    /// the cells that the coefficients are of.
    void (*land)(const SplineCoefficients& spline, std::span<const Vec3> points, Landing* landings);
};

/// All sets that this machine can run, the plain one first.
std::vector<SplineKernels> supported_spline_kernels();

/// The one that is used.
const SplineKernels& spline_kernels();

}  // namespace meniscus
