// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers in as few digits as they need, also where std::to_chars is only for whole numbers, as in Clang's C++ library.
#pragma once

#include <charconv>

namespace meniscus {

#ifndef __cpp_lib_to_chars
char* print_shortest(char* to, char* end, float value);
char* print_shortest(char* to, char* end, double value);
#endif

/// Writes the fewest digits that tell a number from all others of its type, fixed or scientific, whichever is shorter,
/// and returns where they end. Precondition: there is room for 32 characters.
template <class Number>
char* print_shortest(char* to, char* end, Number value) {
    return std::to_chars(to, end, value).ptr;
}

}  // namespace meniscus
