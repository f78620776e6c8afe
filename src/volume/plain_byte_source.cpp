// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Takes the place of gzip_byte_source.cpp in a build without zlib (CMake's MENISCUS_ZLIB=OFF): gzipped files are
// refused.
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "meniscus/errors.h"
#include "reading/gunzip.h"
#include "volume/byte_source.h"

namespace meniscus {
namespace {

std::FILE* handle(void* file) { return static_cast<std::FILE*>(file); }

}  // namespace

ByteSource::ByteSource(const std::string& path) : path_(path), buffer_(new char[kBufferSize]) {
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) fail("is a folder; name a file");
    file_ = std::fopen(path.c_str(), "rb");
    if (file_ == nullptr)
        fail(std::string("cannot be read: ") + std::strerror(errno) + "; check the name and its permissions");
    most_ = std::filesystem::file_size(path, error);
    fill();
    if (reading::is_gzip({buffer_.get(), end_}))
        fail("is gzipped, which this build cannot read (it has no zlib); decompress it first");
}

ByteSource::~ByteSource() {
    if (file_ != nullptr) std::fclose(handle(file_));
}

bool ByteSource::fill() {
    next_ = 0;
    end_ = std::fread(buffer_.get(), 1, kBufferSize, handle(file_));
    if (std::ferror(handle(file_)) != 0) fail("cannot be read to its end; check the disk");
    return end_ > 0;
}

}  // namespace meniscus
