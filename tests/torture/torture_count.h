// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How much is tried: more, or less, on request.
#pragma once

#include <algorithm>
#include <cstdlib>

namespace meniscus::testing {

/// `count` times the environment variable MENISCUS_TORTURE, which is 1 where it is not set; at least 1.
inline int torture_count(int count) {
    const char* times = std::getenv("MENISCUS_TORTURE");
    return times == nullptr ? count : std::max(1, static_cast<int>(count * std::strtod(times, nullptr)));
}

}  // namespace meniscus::testing
