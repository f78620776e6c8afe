// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What SplineCursor and SplineBlock evaluate, for several instruction sets. Every set gives the same bits, and so do
// all ways to the same derivative.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "grid/block_grid.h"
#include "meniscus/level_set.h"

namespace meniscus {

/// Value and gradient of a spline at one point: what a LevelSetSample costs without its second derivatives.
struct ValueAndGradient {
    double value = 0.0;
    Vec3 gradient;
};

/// Where a projection ends, and the spline there.
struct SplineProjection {
    Vec3 point;
    LevelSetSample sample;
};

/// A point's cell and its place in it.
struct PlaceInCell {
    const float* corner = nullptr;  ///< the first of the 4³ coefficients that matter
    std::size_t row = 0;            ///< from one to the next in y
    std::size_t slab = 0;           ///< and in z
    std::array<double, 3> place{};  ///< in spacings from the cell's lower corner
    double steps_per_length = 0.0;  ///< 1/spacing
};

/// The coefficients of a block and of what its cells and those next to it need.
struct SplineCoefficients {
    static constexpr int kBefore = 2;                       ///< nodes before the block's first one
    static constexpr int kEdge = kBefore + kBlockEdge + 3;  ///< nodes along an axis
    static constexpr std::size_t kCount = std::size_t{kEdge} * kEdge * kEdge;

    Vec3 origin;  ///< of the grid, Å
    double spacing = 0.0;
    std::array<std::int64_t, 3> first{};  ///< the first node, x, y, z, counted from the origin
    std::array<float, kCount> values;     ///< x fastest; NaN where there is no block
};

struct SplineKernels {
    std::string_view instructions;
    double (*value)(const PlaceInCell& at);
    ValueAndGradient (*value_and_gradient)(const PlaceInCell& at);
    LevelSetSample (*sample)(const PlaceInCell& at);
    /// Projects points onto the zero set by Newton's method. The sample's value is NaN where that fails or leads out of
    /// the cells that the coefficients are of.
    void (*project)(const SplineCoefficients& spline, std::span<const Vec3> points, SplineProjection* found);
};

/// All sets that this machine can run, the plain one first.
std::vector<SplineKernels> supported_spline_kernels();

/// The one that is used.
const SplineKernels& spline_kernels();

}  // namespace meniscus
