// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Level sets of functions given in closed form, for tests.
#pragma once

#include <algorithm>
#include <cstdlib>
#include <memory>
#include <span>
#include <utility>
#include <vector>

#include "grid/block_grid.h"
#include "grid/stencil.h"
#include "meniscus/level_set.h"
#include "support/sampled_field.h"

namespace meniscus::testing {

/// A stencil applied to the nodes of a block that is given with one layer around it (gather_padded).
inline std::vector<float> with_stencil(const Stencil& stencil, std::span<const float> padded) {
    const double weights[4] = {stencil.centre, stencil.face, stencil.edge, stencil.corner};
    std::vector<float> result(kBlockNodes);
    for (int z = 0; z < kBlockEdge; ++z)
        for (int y = 0; y < kBlockEdge; ++y)
            for (int x = 0; x < kBlockEdge; ++x) {
                double sum = 0.0;
                for (int k = -1; k <= 1; ++k)
                    for (int j = -1; j <= 1; ++j)
                        for (int i = -1; i <= 1; ++i) {
                            const int at = (x + 1 + i) + kPaddedEdge * ((y + 1 + j) + kPaddedEdge * (z + 1 + k));
                            const int axes = std::abs(i) + std::abs(j) + std::abs(k);
                            sum += weights[axes] * double{padded[static_cast<std::size_t>(at)]};
                        }
                result[static_cast<std::size_t>(node_in_block(x, y, z))] = static_cast<float>(sum);
            }
    return result;
}

/// A stencil applied to a whole field, with zero around it.
inline std::vector<float> with_stencil(const Stencil& stencil, const BlockGrid& grid, const std::vector<float>& field) {
    std::vector<float> result(field.size());
    for (BlockId b = 0; b < grid.block_count(); ++b) {
        std::ranges::copy(with_stencil(stencil, gather_padded<float>(grid, field, b, 0.0F)),
                          result.begin() + std::ptrdiff_t{b} * kBlockNodes);
    }
    return result;
}

/// The quasi-interpolating spline of f, good inside the box [low, high].
template <class Function>
LevelSet spline_of(double spacing, const Vec3& low, const Vec3& high, const Function& f, const Vec3& origin = {}) {
    const Vec3 rim = 4.0 * spacing * Vec3{1, 1, 1};  // where zeros beyond the samples reach
    SampledField field = sample_box(spacing, low - rim, high + rim, f, origin);
    const std::vector<float> coefficients = with_stencil(spline_quasi_interpolant(), field.grid, field.values);
    return {std::make_shared<const BlockGrid>(std::move(field.grid)), coefficients};
}

}  // namespace meniscus::testing
