// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The bytes of a file in order, decompressed where it is gzipped, without holding all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

namespace meniscus {

/// throws   InputError "FILE: what is wrong; what to do" from every function
class ByteSource {
public:
    explicit ByteSource(const std::string& path);
    ~ByteSource();
    ByteSource(const ByteSource&) = delete;
    ByteSource& operator=(const ByteSource&) = delete;

    const std::string& path() const { return path_; }
    /// More bytes than this the file cannot hold, even when decompressed.
    std::uint64_t most() const { return most_; }

    static constexpr int kEnd = -1;
    /// The next byte, or kEnd.
    int get() { return next_ < end_ || fill() ? static_cast<unsigned char>(buffer_[next_++]) : kEnd; }
    /// The same, which stays the next one.
    int peek() { return next_ < end_ || fill() ? static_cast<unsigned char>(buffer_[next_]) : kEnd; }
    /// As many bytes as are left, at most `size`; returns their number.
    std::size_t read(char* data, std::size_t size);

private:
    static constexpr std::size_t kBufferSize = std::size_t{1} << 18U;

    bool fill();
    [[noreturn]] void fail(const std::string& what) const;

    std::string path_;
    void* file_ = nullptr;  // gzFile; std::FILE in a build without zlib
    std::uint64_t most_ = 0;
    std::unique_ptr<char[]> buffer_;
    std::size_t next_ = 0;
    std::size_t end_ = 0;
};

}  // namespace meniscus
