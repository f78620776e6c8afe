// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers as text that gives the same number back.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <string_view>

namespace meniscus {

/// Memory for the text of one number.
using Digits = std::array<char, 32>;

/// As few digits as tell a number from all others of its type; nan and inf as such.
std::string_view digits_of(float value, Digits& digits);
std::string_view digits_of(double value, Digits& digits);
std::string_view digits_of(std::uint64_t value, Digits& digits);
std::string_view digits_of(std::int64_t value, Digits& digits);
std::string_view digits_of(std::unsigned_integral auto value, Digits& digits) {
    return digits_of(std::uint64_t{value}, digits);
}

}  // namespace meniscus
