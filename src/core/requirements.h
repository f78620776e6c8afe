// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the options of a computation must be. Messages name the option and its value.
#pragma once

#include <string_view>

namespace meniscus {

/// throws   UsageError "OPTION VALUE: must be WANTED" unless it holds
void require(bool holds, std::string_view option, double value, std::string_view wanted);

bool is_positive(double value);  ///< and finite

/// throws   UsageError for what is_positive() is not true of
void require_positive(std::string_view option, double value);

/// throws   UsageError for what is negative or not finite
void require_not_negative(std::string_view option, double value);

/// throws   UsageError for a negative number of threads
void check_threads(int threads);

}  // namespace meniscus
