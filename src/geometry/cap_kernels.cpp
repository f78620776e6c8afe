// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/cap_kernels.h"

#include "simd/kernels.h"

#define MENISCUS_KERNELS "geometry/cap_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<CapKernels> supported_cap_kernels() { return kernels_of_this_machine(); }
const CapKernels& cap_kernels() { return chosen_kernels(); }

}  // namespace meniscus
