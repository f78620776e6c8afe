// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_lanes.h"

#include "measure/creases.h"
#include "simd/kernels.h"

#define MENISCUS_KERNELS "measure/triangle_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<TriangleKernels> supported_triangle_kernels() { return kernels_of_this_machine(); }
const TriangleKernels& triangle_kernels() { return chosen_kernels(); }

}  // namespace meniscus
