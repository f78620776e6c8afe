// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Words of formats and options, whatever their case.
#pragma once

#include <algorithm>
#include <string>

namespace meniscus {

/// The text with the letters A to Z as a to z, whatever the locale.
inline std::string lower_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return text;
}

}  // namespace meniscus
