// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/block_kernels.h"

#include "simd/kernels.h"

#define MENISCUS_KERNELS "grid/block_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

BlocksAround blocks_around(const BlockGrid& grid, std::span<const float> field, BlockId block, const float* missing) {
    const auto& neighbours = grid.neighbours(block);
    BlocksAround around;
    for (std::size_t slot = 0; slot < neighbours.size(); ++slot) {
        const BlockId b = neighbours[slot];
        around[slot] = b == kNoBlock ? missing : field.data() + std::size_t{b} * kBlockNodes;
    }
    return around;
}

std::vector<BlockKernels> supported_block_kernels() { return kernels_of_this_machine(); }
const BlockKernels& block_kernels() { return chosen_kernels(); }

}  // namespace meniscus
