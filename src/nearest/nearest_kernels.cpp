// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/nearest_kernels.h"

#include "simd/kernels.h"

#define MENISCUS_KERNELS "nearest/nearest_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<NearestKernels> supported_nearest_kernels() { return kernels_of_this_machine(); }
const NearestKernels& nearest_kernels() { return chosen_kernels(); }

}  // namespace meniscus
