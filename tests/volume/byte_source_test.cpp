// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "volume/byte_source.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include "meniscus/errors.h"
#include "support/scratch_folder.h"

namespace meniscus::testing {
namespace {

void write_gzip(const std::string& path, const std::string& content) {
    const gzFile file = ::gzopen(path.c_str(), "wb");
    ASSERT_EQ(::gzwrite(file, content.data(), static_cast<unsigned>(content.size())), static_cast<int>(content.size()));
    ASSERT_EQ(::gzclose(file), Z_OK);
}

std::string all_of(const std::string& path) {
    ByteSource source(path);
    std::string text;
    for (int c = source.get(); c != ByteSource::kEnd; c = source.get()) text.push_back(static_cast<char>(c));
    return text;
}

TEST(ByteSource, GivesTheBytesOfPlainAndGzippedFiles) {
    const ScratchFolder folder;
    std::string content;
    for (unsigned i = 0; i < 500'000; ++i) content.push_back(static_cast<char>(i * i % 251));
    write_file(folder / "plain", content);
    write_gzip(folder / "zipped", content);
    EXPECT_EQ(all_of(folder / "plain"), content);
    EXPECT_EQ(all_of(folder / "zipped"), content);
    EXPECT_EQ(ByteSource(folder / "plain").most(), content.size());
    EXPECT_GE(ByteSource(folder / "zipped").most(), content.size());
}

TEST(ByteSource, PeeksAndReadsInTurn) {
    const ScratchFolder folder;
    write_file(folder / "a", "abcdef");
    ByteSource source(folder / "a");
    EXPECT_EQ(source.peek(), 'a');
    EXPECT_EQ(source.get(), 'a');
    std::string three(3, ' ');
    EXPECT_EQ(source.read(three.data(), 3), 3U);
    EXPECT_EQ(three, "bcd");
    EXPECT_EQ(source.read(three.data(), 3), 2U);
    EXPECT_EQ(source.peek(), ByteSource::kEnd);
    EXPECT_EQ(source.get(), ByteSource::kEnd);
}

TEST(ByteSource, SaysWhatIsWrongWithAFile) {
    const ScratchFolder folder;
    EXPECT_THROW(ByteSource(folder / "missing"), InputError);
    EXPECT_THROW(ByteSource(folder / "."), InputError);
    write_gzip(folder / "zipped", std::string(100'000, 'x') + "yz");
    const std::string whole = read_file(folder / "zipped");
    write_file(folder / "cut", whole.substr(0, whole.size() / 2));
    EXPECT_THROW(all_of(folder / "cut"), InputError);
    std::string damaged = whole;
    damaged[damaged.size() - 6] ^= 1;  // of the checksum
    write_file(folder / "damaged", damaged);
    EXPECT_THROW(all_of(folder / "damaged"), InputError);
}

}  // namespace
}  // namespace meniscus::testing
