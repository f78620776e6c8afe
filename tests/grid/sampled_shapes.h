// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The shapes whose level sets the tests of this room sample, and a corner of the box around them.
#pragma once

#include "meniscus/vec3.h"
#include "support/shapes.h"

namespace meniscus::testing {

inline constexpr Sphere kSphere{.centre = {0.1, -0.2, 0.3}, .radius = 2.5};
inline constexpr Torus kTorus{.major = 3.0, .minor = 1.2};
inline constexpr Vec3 kCorner{4.5, 4.5, 4.5};

}  // namespace meniscus::testing
