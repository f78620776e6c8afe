// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers of foreign files, read strictly.
#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace meniscus::dropins {

/// The finite number that the whole text spells, with or without a plus sign.
inline std::optional<double> strict_number(std::string_view text) {
    if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
    return value;
}

}  // namespace meniscus::dropins
