// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What vectors.inc, few_vectors.inc, arc_tangent.inc and kernel_sets.inc use, which themselves are included into
// namespaces, where no header can be.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <numbers>
#include <type_traits>
#include <vector>

#include "core/arc_tangent_factors.h"
#include "core/bits.h"
#include "meniscus/vec3.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"
