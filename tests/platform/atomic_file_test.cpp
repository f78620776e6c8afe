// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <limits>
#include <stdexcept>

#include "meniscus/errors.h"
#include "support/scratch_folder.h"

namespace meniscus {
namespace {

using testing::read_file;
using testing::ScratchFolder;
using Names = std::vector<std::string>;

std::string message_of(const std::string& path, const std::string& content = "content") {
    try {
        AtomicFile file(path);
        file.write(content);
        file.commit();
    } catch (const OutputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(AtomicFile, CommitGivesTheFileItsName) {
    const ScratchFolder folder;
    AtomicFile file(folder / "a.txt");
    file.write("hello");
    file.write('\n');
    EXPECT_EQ(folder.listing().size(), 1U);
    EXPECT_NE(folder.listing(), Names{"a.txt"});
    file.commit();
    EXPECT_EQ(folder.listing(), Names{"a.txt"});
    EXPECT_EQ(read_file(folder / "a.txt"), "hello\n");
}

TEST(AtomicFile, NothingIsLeftWithoutCommit) {
    const ScratchFolder folder;
    {
        AtomicFile file(folder / "a.txt");
        file.write("half");
    }
    EXPECT_TRUE(folder.listing().empty());
    try {
        AtomicFile file(folder / "a.txt");
        file.write(std::string(1 << 20, 'x'));
        throw std::runtime_error("stop");
    } catch (const std::runtime_error&) {
    }
    EXPECT_TRUE(folder.listing().empty());
}

TEST(AtomicFile, AnOlderFileStaysUntilCommit) {
    const ScratchFolder folder;
    testing::write_file(folder / "a.txt", "old");
    {
        AtomicFile file(folder / "a.txt");
        file.write("new");
    }
    EXPECT_EQ(read_file(folder / "a.txt"), "old");
    AtomicFile file(folder / "a.txt");
    file.write("new");
    EXPECT_EQ(read_file(folder / "a.txt"), "old");
    file.commit();
    EXPECT_EQ(read_file(folder / "a.txt"), "new");
    EXPECT_EQ(folder.listing(), Names{"a.txt"});
}

TEST(AtomicFile, PermissionsAreKept) {
    const ScratchFolder folder;
    testing::write_file(folder / "a.txt", "old");
    ASSERT_EQ(::chmod((folder / "a.txt").c_str(), 0640), 0);
    EXPECT_EQ(message_of(folder / "a.txt"), "no error");
    struct stat found {};
    ASSERT_EQ(::stat((folder / "a.txt").c_str(), &found), 0);
    EXPECT_EQ(found.st_mode & 07777U, 0640U);
}

TEST(AtomicFile, LinksAreFollowed) {
    const ScratchFolder folder;
    testing::write_file(folder / "real.txt", "old");
    std::filesystem::create_symlink("real.txt", folder / "link.txt");
    EXPECT_EQ(message_of(folder / "link.txt"), "no error");
    EXPECT_TRUE(std::filesystem::is_symlink(folder / "link.txt"));
    EXPECT_EQ(read_file(folder / "real.txt"), "content");
}

TEST(AtomicFile, FoldersAndMissingFoldersAreErrorsThatNameThePath) {
    const ScratchFolder folder;
    std::filesystem::create_directory(folder / "sub");
    EXPECT_EQ(message_of(folder / "sub"), (folder / "sub") + ": cannot be written: Is a directory");
    EXPECT_EQ(message_of(folder / "none/a.txt"),
              (folder / "none/a.txt") + ": there is no folder '" + (folder / "none") + "'; create it first");
    EXPECT_EQ(folder.listing(), Names{"sub"});
}

TEST(AtomicFile, ReadOnlyFoldersAndFilesAreErrors) {
    if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write everywhere";
    const ScratchFolder folder;
    testing::write_file(folder / "a.txt", "old");
    ::chmod((folder / "a.txt").c_str(), 0440);
    EXPECT_EQ(message_of(folder / "a.txt"), (folder / "a.txt") + ": cannot be written: Permission denied");
    EXPECT_EQ(read_file(folder / "a.txt"), "old");
    std::filesystem::create_directory(folder / "sub");
    ::chmod((folder / "sub").c_str(), 0550);
    EXPECT_EQ(message_of(folder / "sub/a.txt"), (folder / "sub/a.txt") + ": cannot be written: Permission denied");
    ::chmod((folder / "sub").c_str(), 0750);
}

TEST(AtomicFile, AFullDiskIsAnError) {
    EXPECT_EQ(message_of("/dev/full"), "/dev/full: cannot be written: No space left on device");
    EXPECT_EQ(message_of("/dev/full", std::string(1 << 20, 'x')),
              "/dev/full: cannot be written: No space left on device");
}

TEST(AtomicFile, StandardOutputMayHaveTheSuffixOfAFormat) {
    EXPECT_EQ(standard_output_as("ply"), "/dev/stdout.ply");
    for (const char* path : {"/dev/stdout", "/dev/stdout.ply", "/dev/fd/1"}) EXPECT_TRUE(is_standard_output(path));
    for (const char* path : {"-", "stdout.ply", "/dev/stdout_a.ply", "a.ply"}) EXPECT_FALSE(is_standard_output(path));
}

TEST(AtomicFile, DevicesAreWrittenToDirectly) {
    EXPECT_EQ(message_of("/dev/null"), "no error");
    struct stat found {};
    ASSERT_EQ(::stat("/dev/null", &found), 0);
    EXPECT_TRUE(S_ISCHR(found.st_mode));
}

TEST(AtomicFile, StandardOutputGoesOnWhereItIs) {
    const ScratchFolder folder;
    ::testing::internal::CaptureStdout();
    EXPECT_EQ(message_of("/dev/stdout", "first "), "no error");
    EXPECT_EQ(message_of("/dev/stdout", "second"), "no error");
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "first second");
}

TEST(AtomicFile, LongContentIsWrittenInFull) {
    const ScratchFolder folder;
    std::string content;
    {
        AtomicFile file(folder / "a.txt");
        for (int i = 0; i < 200000; ++i) {
            const std::string line = "line " + std::to_string(i) + "\n";
            content += line;
            file.write(line);
        }
        file.write(content);  // larger than any buffer
        file.commit();
    }
    EXPECT_EQ(read_file(folder / "a.txt"), content + content);
}

TEST(AtomicFile, NumbersReadBackAsTheyWere) {
    const ScratchFolder folder;
    AtomicFile file(folder / "a.txt");
    file.number(0.1F);
    file.write(' ');
    file.number(0.1);
    file.write(' ');
    file.number(static_cast<double>(0.1F));
    file.write(' ');
    file.number(std::numeric_limits<std::uint64_t>::max());
    file.write(' ');
    file.bytes(std::uint16_t{0x4241});
    file.commit();
    EXPECT_EQ(read_file(folder / "a.txt"), "0.1 0.1 0.10000000149011612 18446744073709551615 AB");
}

}  // namespace
}  // namespace meniscus
