// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Normals, curvatures and shape indices of vertices, side by side, for several instruction sets: all give the same
// bits.
#pragma once

#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "grid/spline_kernels.h"
#include "nearest/nearest_kernels.h"

namespace meniscus {

/// Per vertex. Curvatures, Å^-1 and Å^-2, as they are found, then as meshes hold them.
struct ShapeLanes {
    LanePoints<double> normals;
    LaneArray<double> mean;
    LaneArray<double> gaussian;
    LaneArray<float> capped_mean;
    LaneArray<float> capped_gaussian;
    LaneArray<float> shape_index;
};

struct ShapeKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"

    /// Normals, mean and Gaussian curvatures of the level sets through at most kBatchLanes projections; (0, 0, 1) where
    /// the gradient is zero. The same bits as those of LevelSetSample.
    void (*of_projections)(std::span<const SplineProjection, kBatchLanes> projections, std::size_t count,
                           ShapeLanes& lanes);

    /// From mean and Gaussian curvatures what principal_curvatures(mean, gaussian).capped(limit) has, and its shape
    /// index within 2e-8, which is less than single precision keeps. A Gaussian curvature of +inf stands for two equal
    /// principal ones; the limit is in Å^-1.
    void (*cap)(double limit, std::size_t count, ShapeLanes& lanes);
};

/// The kernels that this machine can run, the plainest first.
std::vector<ShapeKernels> supported_shape_kernels();

/// The ones that are used, as in nearest_kernels().
const ShapeKernels& shape_kernels();

}  // namespace meniscus
