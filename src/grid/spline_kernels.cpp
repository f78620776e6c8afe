// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_kernels.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/instructions.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MENISCUS_X86_KERNELS
#endif

namespace meniscus {
namespace {

constexpr double kCloseEnough = 1e-7;  // of a spacing: |Φ| of a landing
constexpr int kUsualSteps = 2;         // of Newton's method
constexpr int kMostSteps = 4;          // after them

namespace plain {
constexpr std::string_view kInstructions = "plain";
#include "grid/spline_kernels.inc"
}  // namespace plain

#ifdef MENISCUS_X86_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
constexpr std::string_view kInstructions = "avx2";
#include "grid/spline_kernels.inc"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f,avx512vl,avx512dq")
namespace avx512 {
constexpr std::string_view kInstructions = "avx512";
#include "grid/spline_kernels.inc"
}  // namespace avx512
#pragma GCC pop_options
#endif

}  // namespace

std::vector<SplineKernels> supported_spline_kernels() {
    std::vector<SplineKernels> kernels{plain::kKernels};
#ifdef MENISCUS_X86_KERNELS
    if (__builtin_cpu_supports("avx2")) kernels.push_back(avx2::kKernels);
    if (__builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq")) kernels.push_back(avx512::kKernels);
#endif
    return kernels;
}

const SplineKernels& spline_kernels() {
    static const SplineKernels chosen = choose_kernels(supported_spline_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
