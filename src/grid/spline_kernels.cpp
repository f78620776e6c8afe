// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_kernels.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>
#include <type_traits>

#include "core/bits.h"
#include "simd/instructions.h"
#include "simd/sign_bits.h"

#define MENISCUS_KERNELS "grid/spline_kernels.inc"

namespace meniscus {
namespace {

constexpr double kCloseEnough = 1e-7;  // of a spacing: |Φ| of a projection
constexpr int kUsualSteps = 2;         // of Newton's method
constexpr int kMostSteps = 4;          // after them

#include "simd/kernel_sets.inc"

}  // namespace

std::vector<SplineKernels> supported_spline_kernels() { return kernels_of_this_machine(); }

const SplineKernels& spline_kernels() {
    static const SplineKernels chosen = choose_kernels(supported_spline_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
