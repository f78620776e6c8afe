// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/read_bytes.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <memory>

#include "meniscus/errors.h"
#include "platform/memory.h"
#include "reading/gunzip.h"

namespace meniscus::reading {
namespace {

// Files below this are read without asking how much memory there is.
constexpr std::size_t kSmall = std::size_t{64} << 20U;

std::size_t largest_text() { return std::max(kSmall, available_memory() / kMemoryPerText); }

[[noreturn]] void fail_too_large(const std::string& path) {
    throw LimitError(path + ": too large for the memory; pass a part of it, or use a machine with more");
}

// likely_size: how much there is, as far as that is known
std::string read_stream(std::FILE* stream, const std::string& path, std::size_t likely_size) {
    std::string bytes;
    bytes.reserve(likely_size);
    std::array<char, std::size_t{1} << 16U> buffer;
    std::size_t limit = kSmall;
    while (const std::size_t count = std::fread(buffer.data(), 1, buffer.size(), stream)) {
        if (bytes.size() + count > limit) {
            if (limit == kSmall) limit = largest_text();
            if (bytes.size() + count > limit) fail_too_large(path);
        }
        bytes.append(buffer.data(), count);
    }
    if (std::ferror(stream) != 0) throw InputError(path + ": cannot be read: " + std::strerror(errno));
    return bytes;
}

}  // namespace

std::string read_bytes(const std::string& path, const std::string& kind) {
    if (path == "-") return read_stream(stdin, path, 0);
    std::error_code ignored;
    if (std::filesystem::is_directory(path, ignored)) {
        throw InputError(path + ": is a folder; name a " + kind);
    }
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> stream(std::fopen(path.c_str(), "rb"), &std::fclose);
    if (!stream) throw InputError(path + ": cannot be opened: " + std::strerror(errno) + "; check the name");
    const std::uintmax_t size = std::filesystem::file_size(path, ignored);  // an error for pipes and devices
    if (!ignored && size > kSmall && size > largest_text()) fail_too_large(path);
    return read_stream(stream.get(), path, ignored ? 0 : size);
}

std::string read_unzipped(const std::string& path, const std::string& kind) {
    std::string bytes = read_bytes(path, kind);
    return is_gzip(bytes) ? gunzip(bytes, path) : bytes;
}

}  // namespace meniscus::reading
