// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/zip_writer.h"

#include <gtest/gtest.h>

#include <array>

#include "support/scratch_folder.h"
#include "support/unzip.h"

namespace meniscus {
namespace {

using Entries = std::map<std::string, std::string>;

std::string written(std::uint64_t zip64_from) {
    const testing::ScratchFolder folder;
    AtomicFile file(folder / "a.zip");
    ZipWriter zip(file, zip64_from);
    zip.add("empty", {});
    const std::string zeros(100000, '0');
    zip.add("two parts", std::array<std::string_view, 2>{"head ", zeros});
    zip.add("last", std::array<std::string_view, 1>{"words"});
    zip.finish();
    file.commit();
    return testing::read_file(folder / "a.zip");
}

TEST(ZipWriter, EntriesReadBack) {
    const Entries expected{{"empty", ""}, {"two parts", "head " + std::string(100000, '0')}, {"last", "words"}};
    EXPECT_EQ(testing::unzip(written(0xffffffffU)), expected);
}

// As if 4 GiB were zero, and as if they were between the offsets of two entries.
TEST(ZipWriter, LargeOnesUseZip64) {
    const Entries expected = testing::unzip(written(0xffffffffU));
    EXPECT_EQ(testing::unzip(written(0)), expected);
    EXPECT_EQ(testing::unzip(written(100)), expected);
    EXPECT_GT(written(100).size(), written(0xffffffffU).size());
    EXPECT_GT(written(0).size(), written(100).size());
}

}  // namespace
}  // namespace meniscus
