// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <zlib.h>

#include <cerrno>
#include <filesystem>
#include <limits>
#include <system_error>

#include "volume/byte_source.h"

namespace meniscus {
namespace {

namespace fs = std::filesystem;

// A byte of gzip data gives at most this many: two bits a match of 258.
constexpr std::uint64_t kMostPerGzipByte = 1032;

std::uint64_t most_bytes(const std::string& path, bool is_plain) {
    std::error_code error;
    if (!fs::is_regular_file(path, error)) return std::numeric_limits<std::uint64_t>::max();
    const std::uint64_t size = fs::file_size(path, error);
    return is_plain ? size : size * kMostPerGzipByte;
}

gzFile handle(void* file) { return static_cast<gzFile>(file); }

}  // namespace

ByteSource::ByteSource(const std::string& path) : path_(path), buffer_(new char[kBufferSize]) {
    std::error_code error;
    if (fs::is_directory(path, error)) fail("is a folder; name a file");
    errno = 0;
    file_ = ::gzopen(path.c_str(), "rb");
    if (file_ == nullptr)
        fail("cannot be read: " + std::generic_category().message(errno) + "; check the name and its permissions");
    most_ = most_bytes(path, ::gzdirect(handle(file_)) != 0);
}

ByteSource::~ByteSource() {
    if (file_ != nullptr) ::gzclose(handle(file_));
}

bool ByteSource::fill() {
    const int count = ::gzread(handle(file_), buffer_.get(), static_cast<unsigned>(kBufferSize));
    int code = Z_OK;
    const std::string message = ::gzerror(handle(file_), &code);
    if (code == Z_BUF_ERROR) fail("the gzip data end too early; the file is cut off, fetch it again");
    if (count < 0 && code == Z_ERRNO) fail("cannot be read to its end; check the disk");
    if (count < 0) fail("the gzip data are damaged; fetch the file again");
    next_ = 0;
    end_ = static_cast<std::size_t>(count);
    return count > 0;
}

}  // namespace meniscus
