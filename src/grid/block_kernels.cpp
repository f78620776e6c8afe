// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_kernels.h"

#include <cstdlib>

namespace meniscus {

// Defined where row_kernels.cpp is compiled for them.
extern const BlockKernels kPlainKernels;
#ifdef MENISCUS_AVX2_KERNELS
extern const BlockKernels kAvx2Kernels;
#endif

std::vector<const BlockKernels*> all_block_kernels() {
    std::vector<const BlockKernels*> all{&kPlainKernels};
#ifdef MENISCUS_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") != 0) all.push_back(&kAvx2Kernels);
#endif
    return all;
}

const BlockKernels& choose_block_kernels(std::string_view instructions) {
    const std::vector<const BlockKernels*> all = all_block_kernels();
    for (const BlockKernels* kernels : all)
        if (kernels->instructions == instructions) return *kernels;
    return *all.back();
}

const BlockKernels& block_kernels() {
    static const BlockKernels& chosen = [&]() -> const BlockKernels& {
        const char* wanted = std::getenv("MENISCUS_INSTRUCTIONS");
        return choose_block_kernels(wanted != nullptr ? wanted : "");
    }();
    return chosen;
}

}  // namespace meniscus
