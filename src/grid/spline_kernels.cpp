// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_kernels.h"

#include "simd/kernels.h"

#define MENISCUS_KERNELS "grid/spline_kernels.inc"

namespace meniscus {
namespace {

constexpr double kCloseEnough = 1e-7;  // of a spacing: |Φ| of a projection
constexpr int kUsualSteps = 2;         // of Newton's method
constexpr int kMostSteps = 4;          // after them

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<SplineKernels> supported_spline_kernels() { return kernels_of_this_machine(); }
const SplineKernels& spline_kernels() { return chosen_kernels(); }

}  // namespace meniscus
