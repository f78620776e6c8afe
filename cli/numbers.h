// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Option values that are numbers, read strictly: the whole text, finite, of the right sign.
#pragma once

#include <cstddef>
#include <string>

namespace meniscus::cli {

/// What a number may be beside finite.
enum class Sign { Positive, NotNegative, Negative, Any };

/// The number that `text` spells.
/// option   the option's name, for the message
/// throws   UsageError when text is not one finite decimal number or has the wrong sign
double parse_number(const std::string& option, const std::string& text, Sign sign);

/// A whole number of at least 1.
/// throws   UsageError
int parse_count(const std::string& option, const std::string& text);

/// An amount of memory, MB (of 2^20 bytes), at least 1: "4G", "500M", "0.5GB"; a bare number counts MB.
/// throws   UsageError
std::size_t parse_memory(const std::string& option, const std::string& text);

/// True for text such as "-0.5", "-.5" and "-inf": a value, although it starts like an option.
bool looks_like_negative_number(const std::string& text);

}  // namespace meniscus::cli
