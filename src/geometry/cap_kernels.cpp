// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/cap_kernels.h"

#include <cmath>
#include <cstring>

#include "core/instructions.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MENISCUS_X86_KERNELS
#endif

namespace meniscus {
namespace {

namespace plain {
constexpr std::string_view kInstructions = "plain";
constexpr std::size_t kVectorBytes = 16;
#include "geometry/cap_kernels.inc"
}  // namespace plain

#ifdef MENISCUS_X86_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
constexpr std::string_view kInstructions = "avx2";
constexpr std::size_t kVectorBytes = 32;
#include "geometry/cap_kernels.inc"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f")
namespace avx512 {
constexpr std::string_view kInstructions = "avx512";
constexpr std::size_t kVectorBytes = 64;
#include "geometry/cap_kernels.inc"
}  // namespace avx512
#pragma GCC pop_options
#endif

}  // namespace

std::vector<CapKernels> supported_cap_kernels() {
    std::vector<CapKernels> kernels{plain::kKernels};
#ifdef MENISCUS_X86_KERNELS
    if (__builtin_cpu_supports("avx2")) kernels.push_back(avx2::kKernels);
    if (__builtin_cpu_supports("avx512f")) kernels.push_back(avx512::kKernels);
#endif
    return kernels;
}

const CapKernels& cap_kernels() {
    static const CapKernels chosen = choose_kernels(supported_cap_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
