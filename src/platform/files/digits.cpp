// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/digits.h"

#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstring>

#include "platform/files/shortest_digits.h"

namespace meniscus {
namespace {

// Those of 0 to 999, three each.
constexpr std::size_t kThousand = 1000;
constexpr std::array<std::array<char, 3>, kThousand> kThreeDigits = [] {
    std::array<std::array<char, 3>, kThousand> all{};
    for (std::size_t i = 0; i < kThousand; ++i)
        all[i] = {static_cast<char>('0' + i / 100), static_cast<char>('0' + i / 10 % 10),
                  static_cast<char>('0' + i % 10)};
    return all;
}();

// A number with at most three decimals, as coordinates have, in the same digits as any other but sooner; empty if it
// has more, or none of the usual size. Doubles are so close to each other there that no shorter digits give the same
// one.
std::string_view digits_of_thousandths(double value, Digits& digits) {
    constexpr double kLargest = 1e5;  // from there on powers of ten are shorter
    constexpr double kLeast = 1e-2;
    const double size = std::abs(value);
    if (!(size >= kLeast && size < kLargest) && size != 0.0) return {};
    const double scaled = size * 1000.0;
    auto thousandths = static_cast<std::uint32_t>(scaled);
    if (scaled - thousandths > 0.5) ++thousandths;
    if (static_cast<double>(thousandths) / 1000.0 != size) return {};
    const std::uint32_t whole = thousandths / 1000;
    const std::uint32_t rest = thousandths % 1000;
    char* end = digits.data();
    if (std::signbit(value)) *end++ = '-';
    if (whole < kThousand) {
        const std::size_t leading_zeros = (whole < 100 ? 1 : 0) + (whole < 10 ? 1 : 0);
        std::memcpy(end, kThreeDigits[whole].data() + leading_zeros, 3 - leading_zeros);
        end += 3 - leading_zeros;
    } else {
        end = std::to_chars(end, digits.data() + digits.size(), whole).ptr;
    }
    if (rest > 0) {
        *end++ = '.';
        std::memcpy(end, kThreeDigits[rest].data(), 3);
        end += 3 - (rest % 10 == 0 ? 1 : 0) - (rest % 100 == 0 ? 1 : 0);
    }
    return {digits.data(), static_cast<std::size_t>(end - digits.data())};
}

template <class T>
std::string_view fewest_digits(T value, Digits& digits) {
    const auto* const end = print_shortest(digits.data(), digits.data() + digits.size(), value);
    return {digits.data(), static_cast<std::size_t>(end - digits.data())};
}

}  // namespace

std::string_view digits_of(float value, Digits& digits) { return fewest_digits(value, digits); }

std::string_view digits_of(double value, Digits& digits) {
    const std::string_view few = digits_of_thousandths(value, digits);
    return few.empty() ? fewest_digits(value, digits) : few;
}

std::string_view digits_of(std::uint64_t value, Digits& digits) { return fewest_digits(value, digits); }

std::string_view digits_of(std::int64_t value, Digits& digits) { return fewest_digits(value, digits); }

}  // namespace meniscus
