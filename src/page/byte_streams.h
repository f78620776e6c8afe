// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Numbers as few bytes: the arrays of a page, which viewer/decode.js reads.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace meniscus::page {

/// Appends seven bits per byte, lowest first; all bytes but the last have the highest bit set.
void append_varint(std::string& bytes, std::uint64_t value);

/// 0, -1, 1, -2 ... as 0, 1, 2, 3 ...
constexpr std::uint64_t zigzag(std::int64_t value) {
    return (static_cast<std::uint64_t>(value) << 1U) ^ static_cast<std::uint64_t>(value >> 63U);
}

/// Each number as its difference to the one before, the first to 0, zigzag, as varints.
template <class Range>
std::string differences(const Range& values) {
    std::string bytes;
    std::int64_t last = 0;
    for (const auto value : values) {
        append_varint(bytes, zigzag(static_cast<std::int64_t>(value) - std::exchange(last, value)));
    }
    return bytes;
}

/// Each byte less the one before, modulo 256.
std::string byte_differences(std::span<const std::uint8_t> values);

/// Named arrays of bytes, one behind the other.
class Streams {
public:
    void add(std::string name, std::string_view bytes);

    struct Place {
        std::string name;
        std::size_t offset;
        std::size_t size;
    };
    const std::vector<Place>& places() const { return places_; }
    const std::string& bytes() const { return bytes_; }

private:
    std::vector<Place> places_;
    std::string bytes_;
};

}  // namespace meniscus::page
