// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers in as few digits as they need, also where std::to_chars is only for whole numbers, as in Clang's C++ library.
#pragma once

#include <charconv>
#include <cstddef>
#include <string>
#include <type_traits>

namespace meniscus {

/// The fewest digits that tell a number from all others of its type, as std::to_chars writes them: fixed or scientific,
/// whichever is shorter. For C++ libraries in which std::to_chars is only for whole numbers.
std::string shortest_text(float value);
std::string shortest_text(double value);

/// Writes the same, or a whole number, and returns where it ends. Precondition: there is room for 32 characters.
template <class Number>
char* print_shortest(char* to, char* end, Number value) {
#ifndef __cpp_lib_to_chars
    if constexpr (std::is_floating_point_v<Number>)
        return to + shortest_text(value).copy(to, static_cast<std::size_t>(end - to));
    else
#endif
        return std::to_chars(to, end, value).ptr;
}

}  // namespace meniscus
