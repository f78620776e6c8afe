// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/density_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

#include "core/bits.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"

#define MENISCUS_KERNELS "flow/density_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<DensityKernels> supported_density_kernels() { return kernels_of_this_machine(); }

const DensityKernels& density_kernels() {
    static const std::vector<DensityKernels> all = supported_density_kernels();
    static const DensityKernels& chosen = choose_kernels(all, wanted_instructions());
    return chosen;
}

}  // namespace meniscus
