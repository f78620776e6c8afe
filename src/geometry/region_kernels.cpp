// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/region_kernels.h"

#include "simd/kernels.h"

#define MENISCUS_KERNELS "geometry/region_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<RegionKernels> supported_region_kernels() { return kernels_of_this_machine(); }
const RegionKernels& region_kernels() { return chosen_kernels(); }

}  // namespace meniscus
