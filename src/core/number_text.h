// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers in messages, the same in every locale.
#pragma once

#include <concepts>
#include <string>
#include <string_view>

namespace meniscus {

/// So many significant digits at most, without zeros behind them: "0.25", "1e+06", "inf".
std::string in_short(double value, int digits = 6);

/// So many digits behind the point: "12.50".
std::string with_decimals(double value, int decimals);

inline void append_part(std::string& text, std::string_view part) { text += part; }
inline void append_part(std::string& text, std::integral auto part) { text += std::to_string(part); }

/// Texts and integers, one after the other.
template <class... Parts>
std::string joined(const Parts&... parts) {
    std::string text;
    (append_part(text, parts), ...);
    return text;
}

}  // namespace meniscus
