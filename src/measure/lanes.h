// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers and vectors side by side: a loop over lanes is one that compilers turn into vector instructions.
#pragma once

#include <array>
#include <cstddef>

#include "meniscus/vec3.h"

namespace meniscus {

inline constexpr std::size_t kLanes = 64;  // the vectors of a triangle's corners stay within a core's first cache

using Lanes = std::array<double, kLanes>;

/// kLanes vectors, by component.
struct VectorLanes {
    Lanes x{};
    Lanes y{};
    Lanes z{};

    void set(std::size_t lane, const Vec3& v) {
        x[lane] = v.x;
        y[lane] = v.y;
        z[lane] = v.z;
    }
    Vec3 at(std::size_t lane) const { return {x[lane], y[lane], z[lane]}; }
};

}  // namespace meniscus
