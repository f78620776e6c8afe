// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/nearest_kernels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/bits.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"

#define MENISCUS_KERNELS "nearest/nearest_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<NearestKernels> supported_nearest_kernels() { return kernels_of_this_machine(); }

const NearestKernels& choose_nearest_kernels(std::string_view instructions) {
    static const std::vector<NearestKernels> all = supported_nearest_kernels();
    return choose_kernels(all, instructions);
}

const NearestKernels& nearest_kernels() {
    static const NearestKernels& chosen = choose_nearest_kernels(wanted_instructions());
    return chosen;
}

}  // namespace meniscus
