// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_lanes.h"

#include <cmath>

#include "core/instructions.h"
#include "measure/corrected.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MENISCUS_X86_KERNELS
#endif

namespace meniscus {
namespace {

namespace plain {
#include "measure/triangle_kernels.inc"
}  // namespace plain

#ifdef MENISCUS_X86_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
#include "measure/triangle_kernels.inc"
}  // namespace avx2
#pragma GCC pop_options
#endif

}  // namespace

std::vector<TriangleKernels> supported_triangle_kernels() {
    std::vector<TriangleKernels> kernels{{"plain", plain::measure, plain::measure_with_parts}};
#ifdef MENISCUS_X86_KERNELS
    if (__builtin_cpu_supports("avx2") != 0) kernels.push_back({"avx2", avx2::measure, avx2::measure_with_parts});
#endif
    return kernels;
}

const TriangleKernels& triangle_kernels() {
    static const TriangleKernels chosen = choose_kernels(supported_triangle_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
