// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_kernels.h"

#include <cstring>

#include "simd/instructions.h"

#define MENISCUS_KERNELS "grid/block_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

void find_blocks_around(const BlockGrid& grid, std::span<const float> field, BlockId block, const float* missing,
                        BlocksAround& around) {
    const auto& neighbours = grid.neighbours(block);
    for (std::size_t slot = 0; slot < neighbours.size(); ++slot) {
        const BlockId b = neighbours[slot];
        around[slot] = b == kNoBlock ? missing : field.data() + std::size_t{b} * kBlockNodes;
    }
}

std::vector<BlockKernels> supported_block_kernels() { return kernels_of_this_machine(); }

const BlockKernels& block_kernels() {
    static const BlockKernels chosen = choose_kernels(supported_block_kernels(), wanted_instructions());
    return chosen;
}

}  // namespace meniscus
