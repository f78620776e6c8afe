// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <limits>

namespace meniscus::testing {
namespace {

TEST(Memory, IsAPlausibleNumberOfBytes) {
    const std::size_t bytes = available_memory();
    EXPECT_GT(bytes, std::size_t{1} << 20U);
    const auto installed =
        static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    if (bytes != std::numeric_limits<std::size_t>::max() / 2) {
        EXPECT_LE(bytes, installed);
    }
}

}  // namespace
}  // namespace meniscus::testing
