// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers from text, all or nothing, without regard to the locale.
#pragma once

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <type_traits>
#ifndef __cpp_lib_to_chars
#include <fast_float/fast_float.h>
#endif

namespace meniscus::reading {

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }
inline bool is_digit(char c) { return c >= '0' && c <= '9'; }
inline bool is_capital(char c) { return c >= 'A' && c <= 'Z'; }
inline bool is_letter(char c) { return is_capital(c) || (c >= 'a' && c <= 'z'); }

/// The text without blanks and tabs at its end.
inline std::string_view without_blank_end(std::string_view text) {
    while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
    return text;
}

/// The text without blanks and tabs at its ends.
inline std::string_view trimmed(std::string_view text) {
    while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
    return without_blank_end(text);
}

/// std::from_chars, also where the C++ library has it only for whole numbers, as Clang's has.
template <class Number>
auto from_chars(const char* begin, const char* end, Number& value) {
#ifndef __cpp_lib_to_chars
    if constexpr (std::is_floating_point_v<Number>)
        return fast_float::from_chars(begin, end, value);
    else
#endif
        return std::from_chars(begin, end, value);
}

/// The whole text (blanks at its ends aside) as a number; nothing if any of it is left over.
template <class Number>
std::optional<Number> whole_number(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number value{};
    const auto [end, error] = from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// Digits with a minus sign before them and a point among them, both of which may be absent: 15 characters at most. The
/// digits as a whole number and the power of ten below them are exact, so their quotient is the nearest number.
inline std::optional<double> short_decimal(std::string_view text) {
    constexpr std::array kPowers{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14};
    if (text.size() > kPowers.size()) return std::nullopt;
    const bool negative = !text.empty() && text.front() == '-';
    if (negative) text.remove_prefix(1);
    std::int64_t digits = 0;
    std::size_t point = text.size();
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] >= '0' && text[i] <= '9')
            digits = 10 * digits + (text[i] - '0');
        else if (text[i] == '.' && point == text.size())
            point = i;
        else
            return std::nullopt;
    }
    const std::size_t decimals = point < text.size() ? text.size() - point - 1 : 0;
    if (text.size() == static_cast<std::size_t>(point < text.size())) return std::nullopt;  // no digit
    const double value = static_cast<double>(digits) / kPowers[decimals];
    return negative ? -value : value;
}

/// The whole text as a finite number; nothing for `********`, blanks, nan, inf, 1e400, 11,104.
inline std::optional<double> finite_number(std::string_view text) {
    text = trimmed(text);
    if (const std::optional<double> value = short_decimal(text)) return value;
    const std::optional<double> value = whole_number<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

inline std::optional<int> integer(std::string_view text) { return whole_number<int>(text); }

}  // namespace meniscus::reading
