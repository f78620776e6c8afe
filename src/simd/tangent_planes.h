// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the surface between two of its points is, by its unit normals there.
#pragma once

#include "meniscus/vec3.h"

namespace meniscus {

#include "simd/tangent_planes.inc"

}  // namespace meniscus
