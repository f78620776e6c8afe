// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/density_kernels.h"

#include "simd/kernels.h"

#define MENISCUS_KERNELS "flow/density_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<DensityKernels> supported_density_kernels() { return kernels_of_this_machine(); }
const DensityKernels& density_kernels() { return chosen_kernels(); }

}  // namespace meniscus
