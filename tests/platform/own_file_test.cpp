// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/own_file.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace meniscus {
namespace {

namespace fs = std::filesystem;

TEST(OwnFile, TheProgramIsThisTest) { EXPECT_EQ(fs::path(program_file()).filename(), "test_platform"); }

TEST(OwnFile, CodeIsInTheProgramAndTheStackIsNowhere) {
    EXPECT_TRUE(fs::equivalent(file_that_holds(reinterpret_cast<const void*>(&program_file)), program_file()));
    const int nowhere = 0;
    EXPECT_EQ(file_that_holds(&nowhere), "");
}

}  // namespace
}  // namespace meniscus
