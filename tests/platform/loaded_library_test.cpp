// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/loaded_library.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>
#include <string>

#include "support/scratch_folder.h"

namespace meniscus::testing {
namespace {

TEST(LoadedLibrary, GivesItsFunctions) {
    const auto library = LoadedLibrary::load("libm.so.6");
    ASSERT_TRUE(library);
    double (*magnitude)(double) = nullptr;
    library->find("fabs", magnitude);
    EXPECT_EQ(magnitude(-2.5), 2.5);
    EXPECT_THROW(library->find("no_function_of_this_name", magnitude), std::runtime_error);
}

TEST(LoadedLibrary, IsNothingWhereItIsNotInstalled) { EXPECT_FALSE(LoadedLibrary::load("libnowhere.so.7")); }

TEST(LoadedLibrary, ADamagedOneIsNotAMissingOne) {
    const ScratchFolder folder;
    const std::string path = folder / "damaged.so";
    std::ofstream(path) << "no library at all, but long enough for the loader to read a header of 64 bytes";
    EXPECT_THROW(LoadedLibrary::load(path.c_str()), std::runtime_error);
}

}  // namespace
}  // namespace meniscus::testing
