// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The corners of triangles as one list of numbers, and quick looks through such lists: four numbers at a time in
// registers that every processor has.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>

#include "meniscus/mesh.h"

namespace meniscus {

/// The corners of all triangles, one after the other: those of triangle t begin at 3 t.
inline std::span<const VertexId> all_corners(std::span<const Triangle> triangles) {
    if (triangles.empty()) return {};
    return {triangles.front().data(), triangles.size() * triangles.front().size()};
}

/// Calls visit(position) for every position of some lists at which a comparison holds, in rising order. Best where it
/// hardly ever does: then sixteen positions take one branch.
///
/// size     of the lists
/// compare  (position, Number{}): of the number there; of four from there on, in a vector, if Number is one
template <class Compare, class Visit>
void for_each_position(std::size_t size, const Compare& compare, const Visit& visit) {
    using Four = std::uint32_t __attribute__((vector_size(16)));
    constexpr std::size_t kFour = 4;
    constexpr std::size_t kBlock = 4 * kFour;
    std::size_t begin = 0;
    for (; begin + kBlock <= size; begin += kBlock) {
        auto any = compare(begin, Four{});
        for (std::size_t i = kFour; i < kBlock; i += kFour) any |= compare(begin + i, Four{});
        std::array<std::uint64_t, 2> bits;
        std::memcpy(bits.data(), &any, sizeof any);
        if ((bits[0] | bits[1]) == 0) continue;
        for (std::size_t i = begin; i < begin + kBlock; ++i)
            if (compare(i, std::uint32_t{})) visit(i);
    }
    for (; begin < size; ++begin)
        if (compare(begin, std::uint32_t{})) visit(begin);
}

template <class Number>
Number number_at(std::span<const std::uint32_t> numbers, std::size_t position) {
    Number number;
    std::memcpy(&number, &numbers[position], sizeof number);
    return number;
}

/// Calls visit(position) wherever a list has a number.
template <class Visit>
void for_each_equal(std::span<const std::uint32_t> numbers, std::uint32_t number, const Visit& visit) {
    for_each_position(
        numbers.size(), [&]<class Number>(std::size_t i, Number) { return number_at<Number>(numbers, i) == number; },
        visit);
}

/// Calls visit(position) wherever two lists have not the same, as far as both go.
template <class Visit>
void for_each_unequal(std::span<const std::uint32_t> a, std::span<const std::uint32_t> b, const Visit& visit) {
    for_each_position(
        std::min(a.size(), b.size()),
        [&]<class Number>(std::size_t i, Number) { return number_at<Number>(a, i) != number_at<Number>(b, i); }, visit);
}

}  // namespace meniscus
