// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Sets of items, one bit for each.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace meniscus {

/// How many bits are set: std::popcount is a call where not every processor that may run this has the instruction for
/// it. Sums of neighbouring bits, then pairs, then fours, and of all bytes by a product.
constexpr std::uint64_t count_bits(std::uint64_t word) {
    word -= (word >> 1U) & 0x5555555555555555U;
    word = (word & 0x3333333333333333U) + ((word >> 2U) & 0x3333333333333333U);
    word = (word + (word >> 4U)) & 0x0F0F0F0F0F0F0F0FU;
    return (word * 0x0101010101010101U) >> 56U;
}

/// The same bits as another type: std::bit_cast, which Emscripten's C++ library does not have.
template <class To, class From>
To bit_cast(const From& from) {
    static_assert(sizeof(To) == sizeof(From) && std::is_trivially_copyable_v<To> && std::is_trivially_copyable_v<From>);
    To to{};
    std::memcpy(&to, &from, sizeof(to));
    return to;
}

/// The bits of a number.
inline std::uint64_t bits_of(double value) { return bit_cast<std::uint64_t>(value); }

/// Calls visit(bit) for every bit that is set, in rising order.
template <class Visit>
void for_each_bit(std::uint64_t word, const Visit& visit) {
    for (; word != 0; word &= word - 1) visit(static_cast<std::size_t>(std::countr_zero(word)));
}

/// The lowest n bits, n in 0..64.
constexpr std::uint64_t first_bits(std::size_t n) { return n == 0 ? 0 : ~std::uint64_t{0} >> (64 - n); }

/// How many words hold a bit for each of so many items.
constexpr std::size_t words_for(std::size_t items) { return (items + 63) / 64; }

/// Calls visit(item) for every item that is in a set, in rising order; there must be no bit set beyond the last item.
template <class Visit>
void for_each_item(const std::uint64_t* words, std::size_t items, const Visit& visit) {
    for (std::size_t w = 0; w < words_for(items); ++w)
        for_each_bit(words[w], [&](std::size_t bit) { visit(64 * w + bit); });
}

/// Writes the items that are in a set, in rising order, and returns how many they are; there must be room for all, and
/// no bit set beyond the last item.
inline std::size_t list_items(const std::uint64_t* words, std::size_t items, std::uint32_t* list) {
    std::size_t count = 0;
    for_each_item(words, items, [&](std::size_t item) { list[count++] = static_cast<std::uint32_t>(item); });
    return count;
}

}  // namespace meniscus
