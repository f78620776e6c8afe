// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A way out along which rays are cast.
#pragma once

#include "meniscus/vec3.h"

namespace meniscus {

/// Nearly a unit vector: no axis of a symmetry, and in no plane of one, of anything made of atoms or lattices.
inline constexpr Vec3 kOddDirection{0.5377, 0.6181, 0.5737};

}  // namespace meniscus
