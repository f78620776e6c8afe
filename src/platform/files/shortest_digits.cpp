// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/shortest_digits.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

namespace meniscus {
namespace {

/// digits[0].digits[1]digits[2]... times ten to the power of `exponent`.
struct Decimal {
    std::string digits;
    int exponent = 0;
};

/// From {fmt}'s text of a positive number, which has the right digits, but fixed or scientific by another rule.
Decimal decimal_of(const std::string& text) {
    const std::size_t e = std::min(text.find('e'), text.size());
    const std::size_t point = std::min(text.find('.'), e);
    Decimal decimal{text.substr(0, point), static_cast<int>(point) - 1};
    if (point < e) decimal.digits += text.substr(point + 1, e - point - 1);
    if (e < text.size()) decimal.exponent += std::atoi(text.c_str() + e + 1);
    const std::size_t zeros = std::min(decimal.digits.find_first_not_of('0'), decimal.digits.size() - 1);
    decimal.digits.erase(0, zeros);
    decimal.exponent -= static_cast<int>(zeros);
    decimal.digits.resize(decimal.digits.find_last_not_of('0') + 1);
    return decimal;
}

std::string scientific(const Decimal& d) {
    const std::string rest = d.digits.size() > 1 ? "." + d.digits.substr(1) : "";
    return fmt::format("{}{}e{}{:02}", d.digits[0], rest, d.exponent < 0 ? '-' : '+', std::abs(d.exponent));
}

/// Whole numbers with more digits than tell them apart are written exactly.
std::string fixed(const Decimal& d, double value) {
    const auto whole = static_cast<std::size_t>(std::max(d.exponent, -1) + 1);
    if (d.exponent < 0) return "0." + std::string(static_cast<std::size_t>(-d.exponent) - 1, '0') + d.digits;
    if (whole >= d.digits.size()) return fmt::format("{:.0f}", value);
    return d.digits.substr(0, whole) + "." + d.digits.substr(whole);
}

/// The length of fixed() without making it, since a number may have 300 digits.
std::size_t fixed_length(const Decimal& d) {
    if (d.exponent < 0) return d.digits.size() + static_cast<std::size_t>(-d.exponent) + 1;
    const auto whole = static_cast<std::size_t>(d.exponent) + 1;
    return whole >= d.digits.size() ? whole : d.digits.size() + 1;
}

template <class T>
std::string shortest(T value) {
    if (!std::isfinite(value) || value == T{0}) return fmt::format("{}", value);
    const Decimal decimal = decimal_of(fmt::format("{}", std::abs(value)));
    std::string text = scientific(decimal);
    if (fixed_length(decimal) <= text.size()) text = fixed(decimal, std::abs(double{value}));
    return std::signbit(value) ? "-" + text : text;
}

}  // namespace

std::string shortest_text(float value) { return shortest(value); }

std::string shortest_text(double value) { return shortest(value); }

}  // namespace meniscus
