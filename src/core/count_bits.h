// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How many bits are set: std::popcount is a call where not every processor that may run this has the instruction for
// it.
#pragma once

#include <cstdint>

namespace meniscus {

/// Sums of neighbouring bits, then pairs, then fours, and of all bytes by a product.
constexpr std::uint64_t count_bits(std::uint64_t word) {
    word -= (word >> 1U) & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + ((word >> 2U) & 0x3333333333333333U);
    word = (word + (word >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
    return (word * 0x0101010101010101U) >> 56U;
}

}  // namespace meniscus
