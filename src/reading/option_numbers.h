// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Option values that are numbers, read strictly: the whole text, and in range.
#pragma once

#include <cstddef>
#include <string>

#include "meniscus/option.h"

namespace meniscus {

/// The number that `text` spells.
/// option   the option's name, for the message
/// throws   UsageError when text is not one decimal number, or is out of range; "inf" is infinite where that is allowed
double parse_number(const std::string& option, const std::string& text, NumberRange range);

/// A whole number of at least 1.
/// throws   UsageError
int parse_count(const std::string& option, const std::string& text);

/// An amount of memory, MB (of 2^20 bytes), at least 1: "4G", "500M", "0.5GB"; a bare number counts MB.
/// throws   UsageError
std::size_t parse_memory(const std::string& option, const std::string& text);

/// True for text such as "-0.5", "-.5" and "-inf": a value, although it starts like an option.
bool looks_like_negative_number(const std::string& text);

}  // namespace meniscus
