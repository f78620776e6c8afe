// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/number_text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstddef>
#include <cstdio>

namespace meniscus {
namespace {

// Locales have other decimal points, and no other character that is neither a letter, a digit nor a sign.
std::string printed(const char* format, int precision, double value) {
    std::array<char, 400> text{};  // the largest number has 309 digits
    std::snprintf(text.data(), text.size(), format, precision, value);
    std::string result = text.data();
    const auto is_point = [](unsigned char c) { return std::isalnum(c) == 0 && c != '+' && c != '-'; };
    const auto begin = std::find_if(result.begin(), result.end(), is_point);
    const auto end = std::find_if_not(begin, result.end(), is_point);
    return begin == end ? result : result.replace(begin, end, ".");
}

}  // namespace

std::string in_short(double value, int digits) { return printed("%.*g", digits, value); }

std::string with_decimals(double value, int decimals) { return printed("%.*f", decimals, value); }

}  // namespace meniscus
