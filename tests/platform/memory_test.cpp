// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/memory.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <limits>
#include <string>

#include "support/scratch_folder.h"

namespace meniscus::testing {
namespace {

TEST(Memory, IsAPlausibleNumberOfBytes) {
    const std::size_t bytes = available_memory();
    EXPECT_GT(bytes, std::size_t{1} << 20U);
    const auto installed =
        static_cast<std::size_t>(::sysconf(_SC_PHYS_PAGES)) * static_cast<std::size_t>(::sysconf(_SC_PAGESIZE));
    if (bytes != std::numeric_limits<std::size_t>::max()) {
        EXPECT_LE(bytes, installed);
    }
}

TEST(Memory, TheTightestGroupCounts) {
    const ScratchFolder folder;
    const std::string root = folder / "cgroup";
    std::filesystem::create_directories(root + "/job/step");
    write_file(folder / "self", "1:name=systemd:/elsewhere\n0::/job/step\n");
    const auto left = [&] { return memory_left_by_groups(folder / "self", root); };
    EXPECT_GT(left(), std::size_t{1} << 62U);
    write_file(root + "/job/step/memory.max", "max\n");
    write_file(root + "/job/memory.max", "1000\n");
    write_file(root + "/job/memory.stat", "anon 300\nfile 600\n");
    EXPECT_EQ(left(), 700U);
    write_file(root + "/memory.max", "500\n");
    EXPECT_EQ(left(), 500U);
}

TEST(Memory, AContainerIsLimitedByTheRootThatItSees) {
    const ScratchFolder folder;
    write_file(folder / "self", "0::/as/its/host/knows/it\n");
    write_file(folder / "memory.max", "500\n");
    EXPECT_EQ(memory_left_by_groups(folder / "self", folder / ""), 500U);
    EXPECT_EQ(memory_left_by_groups(folder / "none", folder / ""), 500U);
}

}  // namespace
}  // namespace meniscus::testing
