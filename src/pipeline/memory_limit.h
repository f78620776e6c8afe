// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The memory that a computation may have.
#pragma once

#include <cstddef>

namespace meniscus {

inline constexpr double kMegabyte = 1024.0 * 1024.0;

/// What is allowed, if it is not 0, else what the machine has left, MB.
double limit_mb(std::size_t memory_limit_mb);

}  // namespace meniscus
