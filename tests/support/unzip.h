// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The smallest reader of ZIP archives, with and without ZIP64, sharing nothing with the writer.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>

namespace meniscus::testing {

/// What a raw deflate stream holds.
inline std::string inflated(const std::string& bytes, std::size_t size) {
    std::string result(size + 1, '\0');  // room to notice more
    z_stream stream{};
    inflateInit2(&stream, -15);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(result.data());
    stream.avail_out = static_cast<uInt>(result.size());
    const int end = inflate(&stream, Z_FINISH);
    const std::size_t left = stream.avail_in;
    result.resize(stream.total_out);
    inflateEnd(&stream);
    if (end != Z_STREAM_END || left > 0) throw std::runtime_error("not one deflate stream");
    return result;
}

inline std::uint32_t crc_of(const std::string& bytes) {
    return static_cast<std::uint32_t>(
        crc32(0, reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uInt>(bytes.size())));
}

template <class T>
T number_at(const std::string& bytes, std::uint64_t offset) {
    T value{};
    if (offset + sizeof value > bytes.size()) throw std::runtime_error("a number beyond the end");
    std::memcpy(&value, bytes.data() + offset, sizeof value);
    return value;
}

/// One entry by its place in the directory: name and content, checked; moves on to the next.
inline std::pair<std::string, std::string> take_entry(const std::string& file, std::uint64_t& at) {
    if (number_at<std::uint32_t>(file, at) != 0x02014b50) throw std::runtime_error("no entry of the directory");
    std::uint64_t compressed = number_at<std::uint32_t>(file, at + 20);
    std::uint64_t size = number_at<std::uint32_t>(file, at + 24);
    std::uint64_t offset = number_at<std::uint32_t>(file, at + 42);
    const auto name_length = number_at<std::uint16_t>(file, at + 28);
    const auto extra_length = number_at<std::uint16_t>(file, at + 30);
    const std::string name = file.substr(at + 46, name_length);
    const std::uint64_t extra = at + 46 + name_length;
    if (size == 0xffffffffU) size = number_at<std::uint64_t>(file, extra + 4);
    if (compressed == 0xffffffffU) compressed = number_at<std::uint64_t>(file, extra + 12);
    if (offset == 0xffffffffU) offset = number_at<std::uint64_t>(file, extra + 20);
    if (number_at<std::uint32_t>(file, offset) != 0x04034b50) throw std::runtime_error("no entry at its place");
    const std::uint64_t start =
        offset + 30 + number_at<std::uint16_t>(file, offset + 26) + number_at<std::uint16_t>(file, offset + 28);
    std::string content = inflated(file.substr(start, compressed), size);
    if (crc_of(content) != number_at<std::uint32_t>(file, at + 16)) throw std::runtime_error("wrong checksum");
    at = extra + extra_length;
    return {name, content};
}

/// Names and contents of all entries.
inline std::map<std::string, std::string> unzip(const std::string& file) {
    const std::uint64_t end = file.size() - 22;
    if (number_at<std::uint32_t>(file, end) != 0x06054b50) throw std::runtime_error("no end of the directory");
    std::uint64_t count = number_at<std::uint16_t>(file, end + 10);
    std::uint64_t at = number_at<std::uint32_t>(file, end + 16);
    if (at == 0xffffffffU) {
        if (number_at<std::uint32_t>(file, end - 20) != 0x07064b50) throw std::runtime_error("no ZIP64 locator");
        const auto record = number_at<std::uint64_t>(file, end - 12);
        if (number_at<std::uint32_t>(file, record) != 0x06064b50) throw std::runtime_error("no ZIP64 end");
        count = number_at<std::uint64_t>(file, record + 32);
        at = number_at<std::uint64_t>(file, record + 48);
    }
    std::map<std::string, std::string> entries;
    for (std::uint64_t i = 0; i < count; ++i) entries.insert(take_entry(file, at));
    return entries;
}

}  // namespace meniscus::testing
