// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/deflate.h"

#include <gtest/gtest.h>

#include <array>

#include "core/parallel.h"
#include "meniscus/threads.h"
#include "support/unzip.h"

namespace meniscus {
namespace {

std::string joined(const Deflated& content) {
    std::string bytes;
    for (const std::string& piece : content.pieces) bytes += piece;
    return bytes;
}

/// Neither all the same nor random: runs of several lengths.
std::string some_bytes(std::size_t size) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>((i * i) >> 11U);
    return bytes;
}

void expect_round_trip(const std::string& first, const std::string& second) {
    const std::array<std::string_view, 2> parts{first, second};
    const Deflated content = deflated(parts);
    const std::string bytes = joined(content);
    EXPECT_EQ(content.size, first.size() + second.size());
    EXPECT_EQ(content.compressed_size(), bytes.size());
    EXPECT_EQ(testing::inflated(bytes, content.size), first + second);
    EXPECT_EQ(content.checksum, testing::crc_of(first + second));
}

TEST(Deflate, GivesBackWhatWasCompressed) {
    expect_round_trip("", "");
    expect_round_trip("head", "");
    expect_round_trip("head", some_bytes(1000));
    expect_round_trip("head", some_bytes(std::size_t{1} << 20U));
    expect_round_trip("head", some_bytes(3333333));
}

TEST(Deflate, BytesDoNotDependOnThreads) {
    const std::string bytes = some_bytes(5000000);
    const std::array<std::string_view, 1> parts{bytes};
    const std::string several = joined(deflated(parts));
    const ThreadLimit one(1);
    EXPECT_EQ(joined(deflated(parts)), several);
}

}  // namespace
}  // namespace meniscus
