// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers from text, all or nothing, without regard to the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace meniscus::reading {

inline bool is_blank(char c) { return c == ' ' || c == '\t'; }

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

/// The whole text (blanks at its ends aside) as a number; nothing if any of it is left over.
template <class Number>
std::optional<Number> whole_number(std::string_view text) {
    text = trimmed(text);
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (text.empty() || error != std::errc() || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// The whole text as a finite number; nothing for `********`, blanks, nan, inf, 1e400, 11,104.
inline std::optional<double> finite_number(std::string_view text) {
    const std::optional<double> value = whole_number<double>(text);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

inline std::optional<int> integer(std::string_view text) { return whole_number<int>(text); }

}  // namespace meniscus::reading
