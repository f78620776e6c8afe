// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Level sets of functions given in closed form, for tests.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "grid/stencil.h"
#include "meniscus/level_set.h"
#include "support/sampled_field.h"

namespace meniscus::testing {

/// A stencil applied to a whole field, with zero around it.
inline std::vector<float> with_stencil(const Stencil& stencil, const BlockGrid& grid, const std::vector<float>& field) {
    std::vector<float> result(field.size());
    for (BlockId b = 0; b < grid.block_count(); ++b) {
        const auto padded = gather_padded<float>(grid, field, b, 0.0F);
        apply_stencil(stencil, std::span<const float, kPaddedNodes>(padded),
                      std::span<float, kBlockNodes>(result.data() + std::size_t{b} * kBlockNodes, kBlockNodes));
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
