// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/shape_kernels.h"

#include "simd/kernels.h"

#define MENISCUS_KERNELS "project/shape_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<ShapeKernels> supported_shape_kernels() { return kernels_of_this_machine(); }
const ShapeKernels& shape_kernels() { return chosen_kernels(); }

}  // namespace meniscus
