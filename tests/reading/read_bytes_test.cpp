// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/read_bytes.h"

#include <gtest/gtest.h>

#include <fstream>
#include <stdexcept>

#include "meniscus/errors.h"
#include "support/scratch_folder.h"

namespace meniscus::reading {
namespace {

TEST(ReadBytes, GivesTheBytesOfTheFile) {
    const testing::ScratchFolder folder;
    const std::string content("a\r\n\0b", 5);
    std::ofstream(folder / "file", std::ios::binary) << content;
    EXPECT_EQ(read_bytes(folder / "file", "file"), content);
    EXPECT_EQ(read_unzipped(folder / "file", "file"), content);
}

TEST(ReadBytes, SaysWhatIsWrongWithThePath) {
    const testing::ScratchFolder folder;
    const auto message = [](const std::string& path) -> std::string {
        try {
            read_bytes(path, "map");
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("no/such.dx"), "no/such.dx: cannot be opened: No such file or directory; check the name");
    EXPECT_NE(message(folder / "").find("is a folder; name a map"), std::string::npos);
}

}  // namespace
}  // namespace meniscus::reading
