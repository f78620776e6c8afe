// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/cap_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/bits.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"

#define MENISCUS_KERNELS "geometry/cap_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<CapKernels> supported_cap_kernels() { return kernels_of_this_machine(); }

const CapKernels& cap_kernels() {
    static const CapKernels chosen = choose_kernels(supported_cap_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
