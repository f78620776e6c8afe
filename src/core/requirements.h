// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the options of a computation must be, and the memory that it may have.
#pragma once

#include <string_view>

#include "meniscus/surface.h"

namespace meniscus {

/// throws   UsageError "OPTION VALUE: must be WANTED" unless it holds
void require(bool holds, std::string_view option, double value, std::string_view wanted);

bool is_positive(double value);  ///< and finite

/// throws   UsageError for what is_positive() is not true of
void require_positive(std::string_view option, double value);

/// throws   UsageError for a negative number of threads
void check_threads(int threads);

inline constexpr double kMegabyte = 1024.0 * 1024.0;

/// What is allowed, if it is not 0, else what the machine has left, MB.
double limit_mb(std::size_t memory_limit_mb);

}  // namespace meniscus
