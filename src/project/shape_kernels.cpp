// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/shape_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <limits>
#include <numbers>
#include <type_traits>

#include "core/bits.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"

#define MENISCUS_KERNELS "project/shape_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<ShapeKernels> supported_shape_kernels() { return kernels_of_this_machine(); }

const ShapeKernels& shape_kernels() {
    static const std::vector<ShapeKernels> all = supported_shape_kernels();
    static const ShapeKernels& chosen = choose_kernels(all, wanted_instructions());
    return chosen;
}

}  // namespace meniscus
