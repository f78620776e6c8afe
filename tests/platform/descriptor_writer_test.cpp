// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/files/descriptor_writer.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstddef>
#include <string>

#include "support/scratch_folder.h"

namespace meniscus {
namespace {

using testing::read_file;
using testing::ScratchFolder;
using Way = DescriptorWriter::Way;

std::string bytes_for(std::size_t size) {
    std::string bytes(size, '\0');
    for (std::size_t i = 0; i < size; ++i) bytes[i] = static_cast<char>(i * 2654435761U >> 13U);
    return bytes;
}

// In pieces of `piece` bytes; returns the error.
int write_in_pieces(const std::string& path, const std::string& bytes, std::size_t piece, Way way) {
    const int descriptor = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0666);
    DescriptorWriter writer(descriptor, way == Way::Cache, way);
    int error = 0;
    for (std::size_t done = 0; done < bytes.size() && error == 0; done += piece)
        error = writer.write(bytes.data() + done, std::min(piece, bytes.size() - done));
    if (error == 0) error = writer.finish();
    ::close(descriptor);
    return error;
}

TEST(DescriptorWriter, FilesHoldTheSameWhoeverTakesThem) {
    const ScratchFolder folder;
    constexpr std::size_t kMebibyte = std::size_t{1} << 20U;
    for (const std::size_t size : {std::size_t{0}, std::size_t{1}, kMebibyte - 1, kMebibyte, 5 * kMebibyte + 4097}) {
        const std::string bytes = bytes_for(size);
        for (const std::size_t piece : {std::size_t{1000}, kMebibyte / 2, 3 * kMebibyte + 1})
            for (const Way way : {Way::Cache, Way::Disk}) {
                const std::string path = folder / "a.bin";
                EXPECT_EQ(write_in_pieces(path, bytes, piece, way), 0);
                EXPECT_TRUE(read_file(path) == bytes) << size << " bytes, " << piece << " at once";
            }
    }
}

TEST(DescriptorWriter, LargeFilesMayChangeTheirWay) {
    const ScratchFolder folder;
    const std::string bytes = bytes_for((std::size_t{50} << 20U) + 12345);
    EXPECT_EQ(write_in_pieces(folder / "a.bin", bytes, std::size_t{1} << 19U, Way::Cache), 0);
    EXPECT_TRUE(read_file(folder / "a.bin") == bytes);
}

TEST(DescriptorWriter, ErrorsAreTold) {
    EXPECT_EQ(write_in_pieces("/dev/full", bytes_for(1000), 1000, Way::Cache), ENOSPC);
    const ScratchFolder folder;
    const std::string bytes = bytes_for(std::size_t{3} << 20U);
    rlimit before{};
    getrlimit(RLIMIT_FSIZE, &before);
    auto* const handler = std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{(std::size_t{1} << 20U) + 5000, before.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
    for (const Way way : {Way::Cache, Way::Disk})
        EXPECT_EQ(write_in_pieces(folder / "a.bin", bytes, bytes.size(), way), EFBIG);
    setrlimit(RLIMIT_FSIZE, &before);
    std::signal(SIGXFSZ, handler);
}

}  // namespace
}  // namespace meniscus
