// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/option_numbers.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>
#include <utility>

#include "meniscus/errors.h"
#include "reading/numbers.h"

namespace meniscus {

namespace {

/// Reads all of `text` as one value, or says no.
template <class T>
bool read_whole(std::string_view text, T& value) {
    const char* end = text.data() + text.size();
    const auto [stop, error] = reading::from_chars(text.data(), end, value);
    return error == std::errc{} && stop == end;
}

/// Splits "4G" into "4" and the number of MB that G stands for; 0 for an unknown unit.
std::pair<std::string_view, double> split_unit(std::string_view text) {
    constexpr std::array<std::pair<std::string_view, double>, 9> kUnits{{{"", 1.0},
                                                                         {"M", 1.0},
                                                                         {"MB", 1.0},
                                                                         {"MiB", 1.0},
                                                                         {"G", 1024.0},
                                                                         {"GB", 1024.0},
                                                                         {"GiB", 1024.0},
                                                                         {"T", 1048576.0},
                                                                         {"TB", 1048576.0}}};
    const std::size_t digits = std::min(text.find_first_not_of("0123456789."), text.size());
    const std::string_view unit = text.substr(digits);
    const auto found = std::find_if(kUnits.begin(), kUnits.end(), [&](const auto& u) { return u.first == unit; });
    return {text.substr(0, digits), found == kUnits.end() ? 0.0 : found->second};
}

}  // namespace

double parse_number(const std::string& option, const std::string& text, NumberRange range) {
    double value = 0.0;
    if (!read_whole(std::string_view(text), value))
        throw UsageError(fmt::format("{}: '{}' is not a valid number", option, text));
    if (!contains(range, value))
        throw UsageError(fmt::format("{}: must be {}, not {}", option, words_for(range), text));
    return value;
}

int parse_count(const std::string& option, const std::string& text) {
    int value = 0;
    if (!read_whole(std::string_view(text), value) || value < 1)
        throw UsageError(fmt::format("{}: must be a whole number of at least 1, not '{}'", option, text));
    return value;
}

std::size_t parse_memory(const std::string& option, const std::string& text) {
    constexpr double kMost = 1e15;  // MB; far above any machine and exact in a double
    const auto [digits, unit] = split_unit(text);
    double value = 0.0;
    if (!read_whole(digits, value) || !(value * unit >= 1.0 && value * unit < kMost))
        throw UsageError(
            fmt::format("{}: must be an amount of memory of at least 1M, such as 4G or 500M, not '{}'", option, text));
    return static_cast<std::size_t>(value * unit);
}

bool looks_like_negative_number(const std::string& text) {
    double value = 0.0;
    return text.size() > 1 && text[0] == '-' && read_whole(std::string_view(text), value);
}

}  // namespace meniscus
