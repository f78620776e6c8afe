// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_kernels.h"

#include "core/instructions.h"

namespace meniscus {

// Defined where row_kernels.cpp is compiled for them.
extern const BlockKernels kPlainKernels;
#ifdef MENISCUS_AVX2_KERNELS
extern const BlockKernels kAvx2Kernels;
#endif

void find_blocks_around(const BlockGrid& grid, std::span<const float> field, BlockId block, const float* missing,
                        BlocksAround& around) {
    const auto& neighbours = grid.neighbours(block);
    for (std::size_t slot = 0; slot < neighbours.size(); ++slot) {
        const BlockId b = neighbours[slot];
        around[slot] = b == kNoBlock ? missing : field.data() + std::size_t{b} * kBlockNodes;
    }
}

std::vector<const BlockKernels*> all_block_kernels() {
    std::vector<const BlockKernels*> all{&kPlainKernels};
#ifdef MENISCUS_AVX2_KERNELS
    if (__builtin_cpu_supports("avx2") != 0) all.push_back(&kAvx2Kernels);
#endif
    return all;
}

const BlockKernels& choose_block_kernels(std::string_view instructions) {
    const std::vector<const BlockKernels*> all = all_block_kernels();
    std::vector<std::string_view> names;
    names.reserve(all.size());
    for (const BlockKernels* kernels : all) names.push_back(kernels->instructions);
    return *all[choose_instructions(names, instructions)];
}

const BlockKernels& block_kernels() {
    static const BlockKernels& chosen = choose_block_kernels(wanted_instructions());
    return chosen;
}

}  // namespace meniscus
