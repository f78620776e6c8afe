// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers and vectors side by side, by component, so that kernels load several into a vector register at once.
#pragma once

#include <array>
#include <cstddef>

#include "meniscus/vec3.h"

namespace meniscus {

inline constexpr std::size_t kLanes = 64;  // the vectors of a triangle's corners stay within a core's first cache

using Lanes = std::array<double, kLanes>;
using SmallLanes = std::array<float, kLanes>;

/// Vectors by component.
template <class T, class Vector, std::size_t kCount = kLanes>
struct LanesOf {
    std::array<T, kCount> x{};
    std::array<T, kCount> y{};
    std::array<T, kCount> z{};

    void set(std::size_t lane, const Vector& v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
    Vector at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};
using VectorLanes = LanesOf<double, Vec3>;
using SmallVectorLanes = LanesOf<float, SmallVec3>;

}  // namespace meniscus
