// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/region_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <numbers>
#include <type_traits>

#include "core/bits.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"

#define MENISCUS_KERNELS "geometry/region_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<RegionKernels> supported_region_kernels() { return kernels_of_this_machine(); }

const RegionKernels& region_kernels() {
    static const RegionKernels chosen = choose_kernels(supported_region_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
