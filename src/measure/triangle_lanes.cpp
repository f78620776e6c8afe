// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_lanes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/bits.h"
#include "measure/creases.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"

#define MENISCUS_KERNELS "measure/triangle_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<TriangleKernels> supported_triangle_kernels() { return kernels_of_this_machine(); }

const TriangleKernels& triangle_kernels() {
    static const TriangleKernels chosen = choose_kernels(supported_triangle_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
