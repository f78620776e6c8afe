// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// ZIP archives, written from beginning to end without going back.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes entries, compressed by deflate, and their directory. All times are 1980-01-01, the earliest that ZIP has, so
/// that the same content gives the same bytes. Entries, and archives, of 4 GiB and more use ZIP64, which Python, Java
/// and unzip 6 read.
/// source   PKWARE, APPNOTE.TXT 6.3.9
class ZipWriter {
public:
    /// zip64_from   sizes and offsets from which ZIP64 is used; tests use it sooner
    explicit ZipWriter(AtomicFile& file, std::uint64_t zip64_from = std::numeric_limits<std::uint32_t>::max())
        : file_(file), zip64_from_(zip64_from) {}

    /// One more entry: what the parts hold one after the other. The name is ASCII.
    void add(std::string name, std::span<const std::string_view> parts);

    /// The directory. Nothing may be added afterwards.
    void finish();

private:
    struct Entry {
        std::string name;
        std::uint32_t checksum = 0;
        std::uint64_t compressed_size = 0;
        std::uint64_t size = 0;
        std::uint64_t offset = 0;  // of its header
    };

    bool is_large(std::uint64_t value) const { return value >= zip64_from_; }
    std::string header_of(const Entry& entry) const;
    std::string directory_entry(const Entry& entry) const;
    std::string end_of_directory(std::uint64_t start, std::uint64_t size) const;
    void write(std::string_view bytes);

    AtomicFile& file_;
    std::uint64_t zip64_from_;
    std::uint64_t offset_ = 0;
    std::vector<Entry> entries_;
};

}  // namespace meniscus
