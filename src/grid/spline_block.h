// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A tri-cubic B-spline around one block after the other: quick for many points near to each other.
#pragma once

#include <span>

#include "grid/spline_cursor.h"
#include "grid/spline_kernels.h"

namespace meniscus {

/// Projects points onto the zero set. For one thread.
class SplineBlock {
public:
    /// Grid and coefficients, one per node, must outlive it.
    SplineBlock(const BlockGrid& grid, std::span<const float> coefficients,
                const SplineKernels& kernels = spline_kernels());

    /// As project_to_zero_set from every point, with the same bits.
    ///
    /// cost     0.1 µs a point where many in a row are in the same block; else that of project_to_zero_set
    void project(std::span<const Vec3> points, std::span<SplineProjection> projections);

private:
    void enter(BlockId block);

    const BlockGrid& grid_;
    std::span<const float> coefficients_;
    const SplineKernels& kernels_;
    SplineCursor cursor_;
    SplineCoefficients around_;
    BlockId block_ = kNoBlock;  // that of around_
};

}  // namespace meniscus
