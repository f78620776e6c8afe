// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/nearest_kernels.h"

#include <cmath>
#include <cstring>
#include <limits>

#include "core/instructions.h"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)
#define MENISCUS_X86_KERNELS
#endif

namespace meniscus {
namespace {

namespace plain {
constexpr std::string_view kInstructions = "plain";
constexpr std::size_t kVectorBytes = 16;
#include "geometry/nearest_kernels.inc"
}  // namespace plain

#ifdef MENISCUS_X86_KERNELS
#pragma GCC push_options
#pragma GCC target("avx2")
namespace avx2 {
constexpr std::string_view kInstructions = "avx2";
constexpr std::size_t kVectorBytes = 32;
#include "geometry/nearest_kernels.inc"
}  // namespace avx2
#pragma GCC pop_options

#pragma GCC push_options
#pragma GCC target("avx512f")
namespace avx512 {
constexpr std::string_view kInstructions = "avx512";
constexpr std::size_t kVectorBytes = 64;
#include "geometry/nearest_kernels.inc"
}  // namespace avx512
#pragma GCC pop_options
#endif

}  // namespace

std::vector<NearestKernels> supported_nearest_kernels() {
    std::vector<NearestKernels> kernels{plain::kKernels};
#ifdef MENISCUS_X86_KERNELS
    if (__builtin_cpu_supports("avx2")) kernels.push_back(avx2::kKernels);
    if (__builtin_cpu_supports("avx512f")) kernels.push_back(avx512::kKernels);
#endif
    return kernels;
}

const NearestKernels& choose_nearest_kernels(std::string_view instructions) {
    static const std::vector<NearestKernels> all = supported_nearest_kernels();
    return choose_kernels(all, instructions);
}

const NearestKernels& nearest_kernels() {
    static const NearestKernels& chosen = choose_nearest_kernels(wanted_instructions());
    return chosen;
}

}  // namespace meniscus
